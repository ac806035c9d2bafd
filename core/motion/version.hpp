#pragma once

#include <string>

#include "core/motion/export.hpp"

namespace morphe {

/// Returns the version of program, library, package and files, "0.1.0", as set in CMakeLists.txt.
MORPHE_EXPORT const char* version();
/// Returns the name of the software as written into files, "morphe 0.1.0".
MORPHE_EXPORT const char* software();
/// Returns the build environment, "GNU 12.2.0, Eigen3 3.4.0, …, x86-64-v3, glibc 2.36". The last
/// digits of a result, and the order in which searches visit states, depend on it. The C library is
/// that of the machine on which the program runs.
MORPHE_EXPORT std::string built_with();

}  // namespace morphe
