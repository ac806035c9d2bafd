#pragma once

#include <array>
#include <string_view>

#include "core/motion/reason.hpp"
#include "pipeline/explain/advice.hpp"

namespace morphe::explain {

/// An advice that does not depend on the numbers of a plan.
struct FixedAdvice {
  AdviceKind kind = AdviceKind::changes_input;
  std::array<std::string_view, 2> settings;  ///< "" for less than two
  std::string_view sentence;                 ///< "" for no advice
};

/// The things that may remove a reason if they change.
struct Dependence {
  bool base = false;      ///< the position of the base
  bool distance = false;  ///< goals that are missed, or bodies that are too close
  bool search = false;    ///< a longer search for postures
};

/// The explanation of a reason: the sentence and the advice that belong to it. The detail of a plan
/// adds the numbers.
struct ReasonExplanation {
  Reason reason = Reason::none;
  std::string_view sentence;
  Dependence depends_on = {};
  std::array<FixedAdvice, 2> advice = {};
};

/// Returns the explanation of a reason. This is the only table of sentences and fixed advice.
const ReasonExplanation& explanation_of(Reason reason);

}  // namespace morphe::explain
