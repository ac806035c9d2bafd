#pragma once

#include "core/humanlike/terms.hpp"

namespace morphe::humanlike {

/// The objective of one frame: the sum of its terms, each multiplied by its weight (0 unless set)
/// and by the frame's factor for its group. It contains the paper's arm-hand objective, Eq. (16),
///   w_x sum ‖x_i - goal_i‖² + w_o sum d_i + w_A A + w_a sum A_i,
/// and further terms: see terms.hpp.
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

/// Buffers and memory of the evaluations of one descent; new_descent() begins another one.
struct ObjectiveScratch {
  std::vector<Pose> base_from_frame;  ///< poses of the frames at the last q
  Loads loads;
  LoadSweep sweep;
  JointVector last_q;  ///< q of the last evaluation with Curvature::exact

  /// Discards the memory of the last descent.
  void new_descent() { loads.forget(); }
};

/// Adds the value, gradient and Hessian of every term at q [n] to the model. `curvature` applies to
/// terms of frames; a JointTerm always adds its Gauss-Newton Hessian.
void add_objective(const FrameObjective& objective, const robot::Robot& robot, const JointVector& q,
                   const FrameGoal& goal, ObjectiveScratch& scratch, solve::Quadratic& model,
                   Curvature curvature = Curvature::gauss_newton);

}  // namespace morphe::humanlike
