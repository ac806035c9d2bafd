#pragma once

#include <string>

#include "core/motion/reason.hpp"

namespace morphe {

/// What stands against something, and a sentence about it. It is true if anything does:
///   if (const Refusal refusal = attempt()) return refusal;
struct Refusal {
  Reason reason = Reason::none;
  std::string detail;

  explicit operator bool() const { return reason != Reason::none; }
};

/// A value, or why there is none. A value beside a refusal is as far as it came: a path with what
/// is still wrong with it, a certificate of what does not hold.
template <class T>
struct Outcome {
  T value;
  Refusal refusal;
};

}  // namespace morphe
