#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace morphe {

/// An enumeration whose values have the same names in configs, files and messages. Its only table
/// of names is declared next to it, with the name of value k at index k:
///
///     enum class Side { right, left };
///     constexpr std::array<std::string_view, 2> names_of(Side) { return {"right", "left"}; }
template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E value) {
  { names_of(value)[0] } -> std::convertible_to<std::string_view>;
};

/// Returns the number of values of the enumeration.
template <NamedEnum E>
constexpr std::size_t enum_count() {
  return names_of(E{}).size();
}

/// Returns the name of a value of the enumeration.
template <NamedEnum E>
constexpr std::string_view name_of(E value) {
  return names_of(value).at(static_cast<std::size_t>(value));
}

/// Returns the value with that name, or nullopt if there is no such value.
template <NamedEnum E>
constexpr std::optional<E> enum_from_name(std::string_view name) {
  constexpr auto names = names_of(E{});
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<E>(k);
  return std::nullopt;
}

/// Returns all names as a list for messages: "right or left"; "human, fastest or duration".
template <NamedEnum E>
std::string list_names() {
  constexpr auto names = names_of(E{});
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) {
    text += k == 0 ? "" : k + 1 == names.size() ? " or " : ", ";
    text += names[k];
  }
  return text;
}

}  // namespace morphe
