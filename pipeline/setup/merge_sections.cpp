#include "pipeline/setup/merge_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/files/sha256.hpp"

namespace morphe::setup {
namespace {

constexpr const char* kHashLinePrefix = "#: ";

std::string hash_of(const std::string& text) { return files::sha256(text).substr(0, 12); }

std::string with_hash_line(const Section& section) {
  return fmt::format("{}{} {}\n{}", kHashLinePrefix, section.name, hash_of(section.text),
                     section.text);
}

struct OldSection {
  std::string name, hash, text;
};

/// Splits a text into its sections, without the text before the first, which is generated anew.
std::vector<OldSection> sections_of(const std::string& text) {
  std::vector<OldSection> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kHashLinePrefix)) {
      std::istringstream words(line.substr(3));
      OldSection section;
      words >> section.name >> section.hash;
      found.push_back(section);
    } else if (!found.empty()) {
      found.back().text += line + "\n";
    }
  }
  return found;
}

}  // namespace

std::string join_sections(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) text += with_hash_line(section);
  return text;
}

std::map<std::string, std::string> edited_sections(const std::string& text) {
  std::map<std::string, std::string> edited;
  for (const OldSection& section : sections_of(text))
    if (hash_of(section.text) != section.hash) edited[section.name] = section.text;
  return edited;
}

std::string merge_sections(const std::vector<Section>& sections, const std::string& before,
                           std::vector<std::string>& kept) {
  const std::vector<OldSection> old = sections_of(before);
  std::string text;
  for (const Section& section : sections) {
    const auto present = std::ranges::find(old, section.name, &OldSection::name);
    if (present == old.end() || hash_of(present->text) == present->hash) {
      text += with_hash_line(section);
    } else {
      kept.push_back(section.name);
      text +=
          fmt::format("{}{} {}\n{}", kHashLinePrefix, present->name, present->hash, present->text);
    }
  }
  return text;
}

}  // namespace morphe::setup
