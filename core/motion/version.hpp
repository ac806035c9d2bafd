#pragma once

#include <string>

#include "core/motion/export.hpp"

namespace morphe {

/// "0.1.0", as CMakeLists.txt says it: of the program, the library, the package and the files.
MORPHE_EXPORT const char* version();
/// "morphe 0.1.0", as files say who wrote them.
MORPHE_EXPORT const char* software();
/// "GNU 12.2.0, Eigen3 3.4.0, …, x86-64-v3, glibc 2.36": what the last digits of a result, and the
/// ways that searches take, depend on. The C library is that of the machine it runs on.
MORPHE_EXPORT std::string built_with();

}  // namespace morphe
