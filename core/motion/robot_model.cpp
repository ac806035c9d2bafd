#include "core/motion/robot_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace morphe {

std::string unchecked_sentence(const std::vector<std::string>& links) {
  if (links.empty()) return "";
  return fmt::format("no contact of {} is checked: no shape is known", fmt::join(links, ", "));
}

}  // namespace morphe
