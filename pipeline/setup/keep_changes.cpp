#include "pipeline/setup/keep_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/files/sha256.hpp"

namespace morphe::setup {
namespace {

constexpr const char* kMark = "#: ";

std::string hash_of(const std::string& text) { return files::sha256(text).substr(0, 12); }

std::string marked(const Section& section) {
  return fmt::format("{}{} {}\n{}", kMark, section.name, hash_of(section.text), section.text);
}

struct OldSection {
  std::string name, hash, text;
};

/// What stands before the first mark belongs to nobody and is made anew.
std::vector<OldSection> sections_of(const std::string& text) {
  std::vector<OldSection> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kMark)) {
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

std::string joined(const std::vector<Section>& sections) {
  std::string text;
  for (const Section& section : sections) text += marked(section);
  return text;
}

std::string joined_over(const std::vector<Section>& sections, const std::string& before,
                        std::vector<std::string>& kept) {
  const std::vector<OldSection> old = sections_of(before);
  std::string text;
  for (const Section& section : sections) {
    const auto there = std::ranges::find(old, section.name, &OldSection::name);
    if (there == old.end() || hash_of(there->text) == there->hash) {
      text += marked(section);
    } else {
      kept.push_back(section.name);
      text += fmt::format("{}{} {}\n{}", kMark, there->name, there->hash, there->text);
    }
  }
  return text;
}

}  // namespace morphe::setup
