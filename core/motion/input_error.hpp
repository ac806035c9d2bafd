#pragma once

#include <stdexcept>
#include <string>

#include "core/motion/export.hpp"

namespace morphe {

/// An error in a file, config or argument. what() has one line per error, "FILE:LINE: KEY: message"
/// or "FILE:/h5/path: message". It is caught once, in main, which exits with code 2.
struct MORPHE_EXPORT InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace morphe
