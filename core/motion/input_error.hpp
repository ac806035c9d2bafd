#pragma once

#include <stdexcept>
#include <string>

#include "core/motion/export.hpp"

namespace morphe {

/// A bad file, config or argument. what() is one line for each thing wrong, "FILE:LINE: KEY:
/// message" or "FILE:/h5/path: message". Caught once, in main: exit code 2.
struct MORPHE_EXPORT InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace morphe
