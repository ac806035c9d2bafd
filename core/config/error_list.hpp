#pragma once

#include <string>
#include <vector>

#include "core/motion/input_error.hpp"

namespace morphe::config {

/// A list of errors, with which all errors of a file are reported together.
class ErrorList {
 public:
  /// Executes a step; returns false if it threw an InputError, which is added to the list.
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
  /// Adds a line, unless it is already in the list.
  void add(const std::string& line);
  /// Adds all lines of another list.
  void add(const ErrorList& more);
  /// Returns true if the list is empty.
  bool none() const { return lines_.empty(); }
  /// Throws one InputError with all lines in the order in which they were added, unless the list is
  /// empty; of more than 20 lines, the rest is only counted.
  void throw_if_any() const;

 private:
  std::vector<std::string> lines_;
};

}  // namespace morphe::config
