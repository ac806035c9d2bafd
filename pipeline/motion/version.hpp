#pragma once

#include "pipeline/motion/export.hpp"

namespace morphe {

/// "0.1.0", as CMakeLists.txt says it: of the program, the library, the package and the files.
MORPHE_EXPORT const char* version();
/// "morphe 0.1.0", as files say who wrote them.
MORPHE_EXPORT const char* software();

}  // namespace morphe
