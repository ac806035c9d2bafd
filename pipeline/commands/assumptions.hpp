#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::commands {

/// What importers assumed, repaired or left out, for people: sentences that differ in their numbers
/// alone are one line, of the first recording that has it.
class Assumptions {
 public:
  void add(const Demonstration& demonstration);
  /// "  NAME: sentence", or "  NAME and 14 more: sentence"; a line each.
  std::string text() const;

 private:
  struct Said {
    std::string name, sentence;
    std::size_t recordings = 0;
  };
  std::vector<Said> said_;
  std::map<std::string, std::size_t> at_;  ///< by the sentence without its numbers
};

}  // namespace morphe::commands
