#pragma once

#include "core/motion/assumption.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// The name of the group of assumptions, which is absent without any.
inline constexpr const char* kAssumptionsGroup = "assumptions";

/// Lays out the content of the group of assumptions.
template <class Io, class T>
void lay_out_assumption_rows(Io& io, T& assumptions) {
  io.column("kind", assumptions, &Assumption::kind, {});
  io.column("subject", assumptions, &Assumption::subject, {});
  io.column("value", assumptions, &Assumption::value, {});
}

/// Lays out the group of assumptions.
template <class Io, class T>
void lay_out_assumptions(Io& io, T& assumptions) {
  io.group_if(!assumptions.empty(), kAssumptionsGroup,
              [&](Io& in) { lay_out_assumption_rows(in, assumptions); });
}

}  // namespace morphe::store
