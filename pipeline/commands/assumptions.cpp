#include "pipeline/commands/assumptions.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>

namespace morphe::commands {
namespace {

std::string without_numbers(std::string sentence) {
  std::erase_if(sentence, [](unsigned char c) { return std::isdigit(c) != 0; });
  return sentence;
}

}  // namespace

void Assumptions::add(const Demonstration& demonstration) {
  std::set<int> counted;
  for (const std::string& sentence : demonstration.import_notes) {
    const auto [entry, is_new] = line_of_.emplace(without_numbers(sentence), lines_.size());
    if (is_new) lines_.push_back({demonstration.name, sentence, 0});
    if (counted.insert(entry->second).second) ++lines_[entry->second].recordings;
  }
}

std::string Assumptions::text() const {
  std::string text;
  for (const Line& line : lines_) {
    text += "  " + line.name;
    if (line.recordings > 1) text += fmt::format(" and {} more", line.recordings - 1);
    text += fmt::format(": {}\n", line.sentence);
  }
  return text;
}

}  // namespace morphe::commands
