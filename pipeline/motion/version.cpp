#include "pipeline/motion/version.hpp"

namespace morphe {

const char* version() { return MORPHE_VERSION; }
const char* software() { return "morphe " MORPHE_VERSION; }

}  // namespace morphe
