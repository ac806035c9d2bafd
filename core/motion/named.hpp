#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace morphe {

/// An enumeration whose values have names, in configs, files and messages alike. Its one table
/// stands beside it, the name of value k at place k:
///
///     enum class Side { right, left };
///     constexpr std::array<std::string_view, 2> names_of(Side) { return {"right", "left"}; }
template <class E>
concept Named = std::is_enum_v<E> && requires(E value) {
  { names_of(value)[0] } -> std::convertible_to<std::string_view>;
};

template <Named E>
constexpr std::size_t count_of() {
  return names_of(E{}).size();
}

/// The name of a value of the enumeration.
template <Named E>
constexpr std::string_view name_of(E value) {
  return names_of(value).at(static_cast<std::size_t>(value));
}

/// The value of that name, none if there is none.
template <Named E>
constexpr std::optional<E> named(std::string_view name) {
  constexpr auto names = names_of(E{});
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (names[k] == name) return static_cast<E>(k);
  }
  return std::nullopt;
}

/// "right or left"; "human, fastest or duration".
template <Named E>
std::string choice_of() {
  constexpr auto names = names_of(E{});
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    text += k == 0 ? "" : k + 1 == names.size() ? " or " : ", ";
    text += names[k];
  }
  return text;
}

}  // namespace morphe
