#pragma once

#include <array>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "core/motion/export.hpp"

namespace morphe {

/// The part that an object plays in a task, as far as the words of the task tell.
enum class TaskKind { unknown, takes_object, touches };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 3> names_of(TaskKind) {
  return {"unknown", "takes_object", "touches"};
}

/// Returns the kind of a task stated in a manifest, such as "drink" or "reach across". A word that
/// takes an object ("drink", "pour", "lift") counts more than one that touches or gestures
/// ("reach", "point", "comb"): "reach to grasp" takes one, but "lift the arm" does not. Inflected
/// words ("drinking", "lifted") are recognised by their stem.
MORPHE_EXPORT TaskKind kind_of_task(std::string_view task);

/// Returns true if a task contains a word, regardless of capitals: "drink" is in "Drink, slowly",
/// but not in "drinking".
MORPHE_EXPORT bool contains_word(std::string_view task, std::string_view word);

}  // namespace morphe
