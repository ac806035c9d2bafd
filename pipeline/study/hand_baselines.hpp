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
/// that its line search minimises another function; here the term is in both. It also filters its
/// output, which causes a lag of several frames, and stops at an absolute change of 1e-6; here
/// there is no filter, and the change is relative.
enum class BaselineMethod { vector, dexpilot };
/// Returns the names of the methods.
constexpr std::array<std::string_view, 2> names_of(BaselineMethod) {
  return {"vector", "DexPilot"};
}

/// The hand and the parameters of a baseline.
struct BaselineHand {
  const robot::Robot& robot;
  int origin = 0;    ///< frame at which the vectors to the tips begin
  double scale = 1;  ///< scale s of the human hand
};

/// The pairs of tips that are closed, which also depends on the frame before.
struct ClosedPairs {
  std::vector<bool> closed;  ///< of (0, 1), (0, 2), …, (1, 2), …; the first tip is the thumb
};

/// Returns the objective of a frame at q, and its gradient [n] unless null. The human tips [m] are
/// given relative to their wrist in the axes of the robot's palm. `closed` has been updated for the
/// frame by update_closed_pairs(), and `q_last` are the joint positions of the frame before.
double baseline_objective(BaselineMethod method, const BaselineHand& hand,
                          const std::vector<Vec3>& human_tips, const ClosedPairs& closed,
                          const JointVector& q_last, const JointVector& q, JointVector* gradient);
/// Updates the closed pairs, at first empty, for the next frame.
void update_closed_pairs(const std::vector<Vec3>& human_tips, ClosedPairs& closed);

/// Returns the path [F, n] of a method for `human_tips` [F][tips of the robot]. The search in the
/// first frame begins at the centre of the joint limits.
JointRows baseline_path(BaselineMethod method, const BaselineHand& hand,
                        const std::vector<std::vector<Vec3>>& human_tips);

}  // namespace morphe::study
