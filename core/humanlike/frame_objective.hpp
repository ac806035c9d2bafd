#pragma once

#include "core/humanlike/terms.hpp"

namespace morphe::humanlike {

/// The paper's arm-hand objective of one frame, Eq. (16), with metric A (and B, C where weighted):
///   w_x sum ‖x_i - goal_i‖² + w_o sum d_o + w_A A + w_a sum A_i  (+ hand orientation, posture,
/// and what joint-to-joint has in their place): the sum of its terms, each times its weight and
/// the frame's share of it. Off as long as no weight is set.
struct FrameObjective {
  Terms terms;

  template <Term T>
  T& get() {
    return std::get<T>(terms);
  }
  template <Term T>
  const T& get() const {
    return std::get<T>(terms);
  }
  /// One after the other, in the order of the list.
  template <class F>
  void each(const F& visit) {
    std::apply([&](Term auto&... term) { (visit(term), ...); }, terms);
  }
  template <class F>
  void each(const F& visit) const {
    std::apply([&](const auto&... term) { (visit(term), ...); }, terms);
  }
};
template <class Fields>
void fields(Fields& f, FrameObjective& o) {
  o.each([&](auto& term) { fields(f, term); });
}

/// What evaluations of one descent share; a new descent begins with new_descent().
struct ObjectiveScratch {
  std::vector<Pose> base_from_frame;  ///< the frames' poses at the last q
  Loads loads;
  LoadSweep sweep;
  JointVector last;  ///< q of the last exact evaluation

  void new_descent() { loads.forget(); }
};

/// Adds every term at q [n] to the model; with Curvature::none the Hessian stays as it is (terms of
/// the joints themselves, which are quadratic, add theirs in any case).
void add_objective(const FrameObjective& objective, const robot::Robot& robot, const JointVector& q,
                   const FrameGoal& goal, ObjectiveScratch& scratch, solve::Quadratic& model,
                   Curvature curvature = Curvature::gauss_newton);

}  // namespace morphe::humanlike
