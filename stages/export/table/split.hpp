#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::exports {

/// The plans that stay on one side of a split: those of one demonstration, or those of one person
/// (of one demonstration, if the recording names no person).
enum class SplitBy { none, demonstration, person };
constexpr std::array<std::string_view, 3> names_of(SplitBy) {
  return {"none", "demonstration", "person"};
}

/// The division of plans into those for training and those for validation.
struct SplitOptions {
  SplitBy by = SplitBy::none;
  double validation_share = 0.1;  ///< of the demonstrations or persons, > 0 and < 1
};

/// The names of the two sides.
inline constexpr std::string_view kTrain = "train", kValid = "valid";

/// Returns the key of a plan: plans with the same key are on the same side.
std::string split_key(const Plan& plan, SplitBy by);

/// Returns for each plan the name of its side, given its key. The side depends on the hash of the
/// key alone, so that it is the same in every file, for every robot and after others were added,
/// except where a side would be empty: if all keys would be for validation, that with the greatest
/// hash is for training; if none would, and there are several, that with the least hash is for
/// validation.
std::vector<std::string_view> split_sides(const std::vector<std::string>& keys,
                                          double validation_share);

}  // namespace morphe::exports
