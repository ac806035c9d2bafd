#pragma once

#include <string>
#include <string_view>

namespace morphe {

/// "1 plan", "2 plans", "0 plans": a number with what it counts, as people say it. The plural has
/// an s, if no other is given.
template <class Integer>
std::string counted(Integer count, std::string_view one, std::string_view many = "") {
  std::string text = std::to_string(count) + " ";
  if (count == 1) return text.append(one);
  return many.empty() ? text.append(one) + "s" : text.append(many);
}

}  // namespace morphe
