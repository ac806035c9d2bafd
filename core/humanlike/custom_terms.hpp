#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/humanlike/term.hpp"
#include "core/motion/key_bounds.hpp"
#include "core/motion/residual_term.hpp"

namespace morphe::humanlike {

/// An entry of a config for a term that the calling program provides.
struct CustomTerm {
  std::string name;  ///< ResidualTerm::name() of the provided term
  double weight = 0;
  std::shared_ptr<const ResidualTerm> term;  ///< null before resolve_custom_terms()
};

/// Sum of weight_i ‖r_i(q)‖² over the entries. It is inactive before resolve_custom_terms().
struct CustomTerms {
  static constexpr TermGroup kGroup = TermGroup::posture;
  double weight = 0;
  std::vector<CustomTerm> entries;

  /// Adds the terms, multiplied by `share`, to the model. Throws InputError if a term's residuals
  /// [k] and Jacobian [k, n] do not have these sizes or are not finite.
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
};
/// Declares the config keys of an entry.
template <class Fields>
void fields(Fields& f, CustomTerm& o) {
  f.required("name", o.name);
  f.required("weight", o.weight, bounds::kWeight);
}
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, CustomTerms& o) {
  f("custom_terms", o.entries);
}

/// Assigns the provided terms to the entries and sets the weight to 1. Returns the first name that
/// is not provided, or "".
std::string resolve_custom_terms(const std::vector<std::shared_ptr<const ResidualTerm>>& provided,
                                 CustomTerms& terms);

}  // namespace morphe::humanlike
