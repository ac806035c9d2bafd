#pragma once

#include <array>
#include <string>

#include "core/motion/clearance_kind.hpp"

namespace morphe::verify {

/// The least clearances of a motion by kind [m], +infinity for a kind without pairs.
using ClearanceByKind = std::array<double, kClearanceKindCount>;

/// Returns clearances without any pair.
constexpr ClearanceByKind no_clearance() { return {kInfinity, kInfinity, kInfinity, kInfinity}; }

/// Returns the kind of the pairs of an object with bodies other than the target itself.
inline ClearanceKind kind_of_object(const std::string& name, const std::string& target) {
  if (name == target) return ClearanceKind::target;
  return name == "table" ? ClearanceKind::table : ClearanceKind::objects;
}

}  // namespace morphe::verify
