#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/robot/robot.hpp"
#include "core/solve/minimise.hpp"

namespace morphe::study {

/// The published methods for mapping a hand alone, frame by frame, starting from the joint
/// positions of the previous frame (Qin et al. 2023, "AnyTeleop", and Handa et al. 2020,
/// "DexPilot", as published in dex-retargeting), with
///   H(x, b) = x²/2b up to b, x - b/2 beyond it,
/// the robot's vectors r, the human's vectors h, the scale s of the human hand and the number n of
/// vectors:
///   vector    f = 1/n sum H(‖r_i - s h_i‖, 0.02), from the origin to each tip
///   dexpilot  f = 1/n sum w_i H(‖r_i - t_i‖, 0.03), from the thumb to each finger, between
///             fingers, and from the origin to each tip: t = s h and w = 1 (for tips: the number
///             of vectors between tips plus the number of tips). A pair with the thumb is closed,
///             t = 1e-4 m along h and w = 200, from ‖h‖ < 0.03 until ‖h‖ > 0.05; a pair of
///             fingers, t = 0.03 m and w = 400, while both are closed with the thumb and
///             ‖h‖ <= 0.03.
/// Both add 4e-3 ‖q - q_last‖². The published implementation has this term only in its gradient, so
/// that its line search minimises another function; here the term is in both. The published
/// implementation filters its output, which causes a lag of several frames; this one does not
/// filter. Both stop at a relative change of 1e-6, whereas the published one stops at an absolute
/// change of 1e-6.
enum class BaselineMethod { vector, dexpilot };
/// Returns the names of the methods.
constexpr std::array<std::string_view, 2> names_of(BaselineMethod) {
  return {"vector", "DexPilot"};
}

/// The hand and the parameters of a baseline.
struct BaselineHand {
  /// The robot hand.
  const robot::Robot& robot;
  /// Frame at which the vectors to the tips begin.
  int origin = 0;
  /// Scale s of the human hand.
  double scale = 1;
};

/// The pairs of tips that are closed, as carried from one frame to the next.
struct ClosedPairs {
  std::vector<bool> closed;  ///< pairs with the thumb come first
};

/// Computes the objective of a frame at q. The human tips [m] are given relative to their wrist in
/// the axes of the robot's palm. `closed` must be updated for the frame first
/// (update_closed_pairs). Adds to gradient [n] if it is not null.
double baseline_objective(BaselineMethod method, const BaselineHand& hand,
                          const std::vector<Vec3>& human_tips, const ClosedPairs& closed,
                          const JointVector& last, const JointVector& q, JointVector* gradient);
/// Updates the closed pairs for a frame.
void update_closed_pairs(const std::vector<Vec3>& human_tips, ClosedPairs& closed);

/// Computes a path [F, n] that starts at the centre of the joint limits. human_tips is [F][tips in
/// the robot's order].
JointRows baseline_path(BaselineMethod method, const BaselineHand& hand,
                        const std::vector<std::vector<Vec3>>& human_tips);

}  // namespace morphe::study
