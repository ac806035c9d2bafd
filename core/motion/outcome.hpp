#pragma once

#include <string>

#include "core/motion/reason.hpp"

namespace morphe {

/// The reason why planning failed, and a sentence about it. It converts to true on failure:
///   if (const PlanningFailure failure = attempt()) return failure;
struct PlanningFailure {
  Reason reason = Reason::none;
  std::string detail;

  /// Returns true if planning failed.
  explicit operator bool() const { return reason != Reason::none; }
};

/// A value, or the reason why it could not be computed. A value next to a failure is a partial
/// result: a path with its remaining findings, or a certificate of the properties that do not hold.
template <class T>
struct Outcome {
  T value;
  PlanningFailure failure;
};

}  // namespace morphe
