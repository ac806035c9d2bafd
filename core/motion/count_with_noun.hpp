#pragma once

#include <string>
#include <string_view>

namespace morphe {

/// Returns "1 plan", "2 plans", "0 plans": `many`, if given, is the plural, else `one` and an s.
template <class Integer>
std::string count_with_noun(Integer count, std::string_view one, std::string_view many = "") {
  std::string text = std::to_string(count) + " ";
  if (count == 1) return text.append(one);
  return many.empty() ? text.append(one) + "s" : text.append(many);
}

}  // namespace morphe
