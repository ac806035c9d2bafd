#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/humanlike/term.hpp"
#include "core/motion/residual_term.hpp"

namespace morphe::humanlike {

/// A term that the calling program provides, under the name that the config gives it.
struct CustomTerm {
  std::string name;
  double weight = 0;
  std::shared_ptr<const ResidualTerm> term;
};

/// Sum of weight_i ‖r_i(q)‖² over the given terms. It is active once resolve_custom_terms() has
/// found the terms that the config names.
struct CustomTerms {
  static constexpr TermGroup kGroup = TermGroup::posture;
  double weight = 0;
  std::vector<CustomTerm> entries;

  /// Adds the terms; throws InputError if a term's residuals and Jacobian are not [k] and [k, n] or
  /// not finite.
  void add(const RobotState& state, const FrameGoal& goal, double share,
           solve::Quadratic& model) const;
};
/// Declares the config keys of an entry.
template <class Fields>
void fields(Fields& f, CustomTerm& o) {
  f.required("name", o.name);
  f.required("weight", o.weight);
}
/// Returns the reason why the options are invalid, "" if they are valid.
std::string validation_error(const CustomTerm& options);
/// Declares the config keys of the term.
template <class Fields>
void fields(Fields& f, CustomTerms& o) {
  f("custom_terms", o.entries);
}

/// Assigns the provided terms to the entries by name; returns the first name that is not provided,
/// or "".
std::string resolve_custom_terms(const std::vector<std::shared_ptr<const ResidualTerm>>& brought,
                                 CustomTerms& terms);

}  // namespace morphe::humanlike
