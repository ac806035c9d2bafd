#pragma once

#include "core/humanlike/terms.hpp"

namespace morphe::humanlike {

/// The paper's arm-hand objective of one frame, Eq. (16), with metric A (and B, C if weighted):
///   w_x sum ‖x_i - goal_i‖² + w_o sum d_o + w_A A + w_a sum A_i  (+ hand orientation, posture,
/// and the terms that replace them in joint-to-joint mode). It is the sum of its terms, each
/// multiplied by its weight and the frame's factor for its group, and is inactive as long as no
/// weight is set.
struct FrameObjective {
  Terms terms;

  /// Returns the term of a type.
  template <Term T>
  T& get() {
    return std::get<T>(terms);
  }
  /// Returns the term of a type.
  template <Term T>
  const T& get() const {
    return std::get<T>(terms);
  }
  /// Visits all terms in the order of the list.
  template <class F>
  void for_each_term(const F& visit) {
    std::apply([&](Term auto&... term) { (visit(term), ...); }, terms);
  }
  /// Visits all terms in the order of the list.
  template <class F>
  void for_each_term(const F& visit) const {
    std::apply([&](const auto&... term) { (visit(term), ...); }, terms);
  }
};
/// Declares the config keys of all terms.
template <class Fields>
void fields(Fields& f, FrameObjective& o) {
  o.for_each_term([&](auto& term) { fields(f, term); });
}

/// Buffers that the evaluations of one descent share; new_descent() must be called before the next
/// descent.
struct ObjectiveScratch {
  std::vector<Pose> base_from_frame;  ///< poses of the frames at the last q
  Loads loads;
  LoadSweep sweep;
  JointVector last_q;  ///< q of the last exact evaluation

  /// Discards the memory of the last descent.
  void new_descent() { loads.forget(); }
};

/// Adds the value, gradient and Hessian of every term at q [n] to the model. With Curvature::none
/// the Hessian is unchanged, except for terms of the joints themselves, which are quadratic.
void add_objective(const FrameObjective& objective, const robot::Robot& robot, const JointVector& q,
                   const FrameGoal& goal, ObjectiveScratch& scratch, solve::Quadratic& model,
                   Curvature curvature = Curvature::gauss_newton);

}  // namespace morphe::humanlike
