#include "core/motion/version.hpp"

#include <gnu/libc-version.h>

namespace morphe {

const char* version() { return MORPHE_VERSION; }
const char* software() { return "morphe " MORPHE_VERSION; }
std::string built_with() {
  return std::string(MORPHE_BUILT_WITH ", glibc ") + gnu_get_libc_version();
}

}  // namespace morphe
