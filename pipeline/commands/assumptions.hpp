#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::commands {

/// A summary of the flags and import notes of recordings: doubts, and the properties that importers
/// assumed, repaired or left out. Notes that differ only in their digits become one line, with the
/// text of the first.
class Assumptions {
 public:
  /// Adds the flags and import notes of a recording.
  void add(const Demonstration& demonstration);
  /// Returns lines "  NAME: sentence" or, for several recordings, "  NAME and 14 more: sentence".
  std::string text() const;

 private:
  struct Line {
    std::string name, sentence;
    int recordings = 0;
  };
  std::vector<Line> lines_;
  std::map<std::string, int> line_of_;  ///< index by the sentence without its numbers
};

}  // namespace morphe::commands
