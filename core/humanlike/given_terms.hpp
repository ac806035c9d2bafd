#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/humanlike/term.hpp"
#include "core/motion/residual_term.hpp"

namespace morphe::humanlike {

/// A term that the calling program brings along, by the name that the config gives it.
struct GivenTerm {
  std::string name;
  double weight = 0;
  std::shared_ptr<const ResidualTerm> term;
};

/// Sum of weight_i ‖r_i(q)‖² over the given terms. They are on once bring() has found what the
/// config names.
struct GivenTerms {
  static constexpr Group kGroup = Group::posture;
  double weight = 0;
  std::vector<GivenTerm> entries;

  /// InputError if a term's residuals and Jacobian are not [k] and [k, n] or not finite.
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
};
template <class Fields>
void fields(Fields& f, GivenTerm& o) {
  f.required("name", o.name);
  f.required("weight", o.weight);
}
std::string why_invalid(const GivenTerm& options);
template <class Fields>
void fields(Fields& f, GivenTerms& o) {
  f("terms", o.entries);
}

/// Gives the entries the terms of their names; returns the first name that is not among them, "" if
/// there is none.
std::string bring(const std::vector<std::shared_ptr<const ResidualTerm>>& brought,
                  GivenTerms& terms);

}  // namespace morphe::humanlike
