#include "core/motion/key_bounds.hpp"

#include <fmt/format.h>

namespace morphe {

std::string text_of(const KeyBounds& bounds) {
  return fmt::format("{} {:g} and {} {:g}{}{}{}", bounds.lower_open ? "above" : "at least",
                     bounds.lower, bounds.upper_open ? "below" : "at most", bounds.upper,
                     *bounds.unit ? " " : "", bounds.unit, bounds.reason);
}

}  // namespace morphe
