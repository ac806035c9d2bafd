#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/robot/robot.hpp"
#include "core/solve/minimise.hpp"

namespace morphe::study {

/// How others map a hand alone, frame by frame from the last frame's joints (Qin et al. 2023,
/// "AnyTeleop", and Handa et al. 2020, "DexPilot", as dex-retargeting publishes them), with
///   H(x, b) = x²/2b up to b, x - b/2 beyond it,
/// r the robot's vectors, h the human's, s the scale of the human hand, n their number:
///   vector    f = 1/n sum H(‖r_i - s h_i‖, 0.02), from the origin to each tip
///   dexpilot  f = 1/n sum w_i H(‖r_i - t_i‖, 0.03), from the thumb to each finger, between
///             fingers, and from the origin to each tip: t = s h and w = 1 (to tips: as many as
///             there are vectors between tips, and as tips). A pair with the thumb is closed,
///             t = 1e-4 m along h and w = 200, from ‖h‖ < 0.03 until ‖h‖ > 0.05; one of fingers,
///             t = 0.03 m and w = 400, while both are closed with the thumb and ‖h‖ <= 0.03.
/// Both add 4e-3 ‖q - q_last‖². Theirs has that term in its gradient alone, so that its line search
/// sees another function; here it is in both. Theirs filters the output, which lags by frames; here
/// nothing does. Both stop at a relative change of 1e-6 where theirs stops at one of 1e-6 itself.
enum class PeerMethod { vector, dexpilot };
constexpr std::array<std::string_view, 2> names_of(PeerMethod) { return {"vector", "DexPilot"}; }

struct PeerHand {
  const robot::Robot& robot;
  int origin = 0;    ///< frame from which vectors point to the tips
  double scale = 1;  ///< s
};

/// Which pairs of tips are closed, from one frame to the next.
struct ClosedPairs {
  std::vector<bool> closed;  ///< thumb's pairs first
};

/// A frame's objective at q, human tips [m] given about their wrist in the axes of the robot's
/// palm. `closed` is brought up to the frame first (update_closed). Adds to gradient [n] if not
/// null.
double peer_objective(PeerMethod method, const PeerHand& hand, const std::vector<Vec3>& human_tips,
                      const ClosedPairs& closed, const JointVector& last, const JointVector& q,
                      JointVector* gradient);
void update_closed(const std::vector<Vec3>& human_tips, ClosedPairs& closed);

/// [F, n] from the middle of the limits on. human_tips [F][tips in the robot's order].
JointRows peer_course(PeerMethod method, const PeerHand& hand,
                      const std::vector<std::vector<Vec3>>& human_tips);

}  // namespace morphe::study
