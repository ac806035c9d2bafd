#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::commands {

/// A summary of the values that importers assumed, repaired or left out. Sentences that differ only
/// in their numbers are one line, with the text of the first recording that has it.
class Assumptions {
 public:
  /// Adds the reports of a recording.
  void add(const Demonstration& demonstration);
  /// Returns one line for each sentence: "  NAME: sentence", or "  NAME and 14 more: sentence".
  std::string text() const;

 private:
  struct Line {
    std::string name, sentence;
    std::size_t recordings = 0;
  };
  std::vector<Line> said_;
  /// Index by the sentence without its numbers.
  std::map<std::string, std::size_t> at_;
};

}  // namespace morphe::commands
