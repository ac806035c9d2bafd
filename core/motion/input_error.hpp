#pragma once

#include <stdexcept>
#include <string>

#include "core/motion/export.hpp"

namespace morphe {

/// An error in a file, config or argument. what() has one line per error, "FILE:LINE: KEY: message"
/// or "FILE:/h5/path: message". If it reaches main, it is printed, and the exit code is 2.
struct MORPHE_EXPORT InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace morphe
