#pragma once

#include "core/motion/assumption.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// Lays out the group of assumptions, which is absent without any.
template <class Io, class T>
void lay_out_assumptions(Io& io, T& assumptions) {
  io.group_if(!assumptions.empty(), "assumptions", [&](Io& in) {
    in.column("kind", assumptions, &Assumption::kind, {});
    in.column("subject", assumptions, &Assumption::subject, {});
    in.column("value", assumptions, &Assumption::value, {});
  });
}

}  // namespace morphe::store
