#include "pipeline/commands/assumptions.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>
#include <vector>

#include "core/motion/flag_text.hpp"

namespace morphe::commands {
namespace {

std::string without_numbers(std::string sentence) {
  std::erase_if(sentence, [](unsigned char c) { return std::isdigit(c) != 0; });
  return sentence;
}

}  // namespace

void Assumptions::add(const Demonstration& demonstration) {
  std::vector<std::string> sentences;
  for (const RecordingFlag& flag : demonstration.flags)
    sentences.push_back("flag: " + sentence(flag));
  sentences.insert(sentences.end(), demonstration.import_notes.begin(),
                   demonstration.import_notes.end());
  std::set<int> counted;
  for (const std::string& line : sentences) {
    const auto [entry, is_new] = line_of_.emplace(without_numbers(line), lines_.size());
    if (is_new) lines_.push_back({demonstration.name, line, 0});
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
