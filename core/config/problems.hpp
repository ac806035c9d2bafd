#pragma once

#include <string>
#include <vector>

#include "core/motion/input_error.hpp"

namespace morphe::config {

/// What is wrong with a file, so that all of it is told at once.
class Problems {
 public:
  /// Does a step; false if it threw an InputError, which is kept.
  template <class Step>
  bool attempt(const Step& step) {
    try {
      step();
      return true;
    } catch (const InputError& error) {
      add(error.what());
      return false;
    }
  }
  /// One line more, if nobody said it before.
  void add(const std::string& line);
  void add(const Problems& more);
  bool none() const { return lines_.empty(); }
  /// Throws one InputError of all lines, in the order in which they came (of more than 20 the rest
  /// is counted); nothing if there are none.
  void throw_any() const;

 private:
  std::vector<std::string> lines_;
};

}  // namespace morphe::config
