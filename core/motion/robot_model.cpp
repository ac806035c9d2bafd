#include "core/motion/robot_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace morphe {

std::string unchecked_sentence(const std::vector<std::string>& links) {
  if (links.empty()) return "";
  return fmt::format("collisions of {} are not checked: no collision shape given",
                     fmt::join(links, ", "));
}

}  // namespace morphe
