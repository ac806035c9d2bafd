#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/motion/hand_bones.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::map {

/// How large the human's hand is made for a robot's hand alone.
///   given  `factor` times
///   palm   as broad over the knuckles as the robot's
///   found  as large as it may be with no finger longer than the robot's, knuckle's axis to tip
enum class HandScale { given, palm, found };
constexpr std::array<std::string_view, 3> names_of(HandScale) { return {"given", "palm", "found"}; }

/// Where it is laid: its wrist where the robot's palm stands, or its knuckles on the robot's, which
/// is the same for every choice of the palm's origin.
enum class HandAt { palm, knuckles };
constexpr std::array<std::string_view, 2> names_of(HandAt) { return {"palm", "knuckles"}; }

/// Config section `hand`: for robots without an arm.
struct HandOptions {
  HandScale scale = HandScale::given;
  double factor = 1;  ///< of scale given
  HandAt at = HandAt::palm;
};
template <class Fields>
void fields(Fields& f, HandOptions& o) {
  f("scale", o.scale);
  f("factor", o.factor);
  f("at", o.at);
}
std::string why_invalid(const HandOptions& options);

/// palm_from_human: p -> scale * p + offset, both in their hand's own axes.
struct HandFit {
  double scale = 1;
  Vec3 offset = Vec3::Zero();  ///< [m]
  std::string problem;         ///< a sentence if it could not be made as asked for: what is unknown
};

/// By the fingers that both hands have, the thumb not among them:
///   found   scale = least of robot's over human's lengths
///   palm    scale = robot's over human's distance of the outermost knuckles
///   offset = mean of (robot's knuckle - scale * human's)                       (at knuckles)
HandFit fit_hand(const HandBones& robot, const HandBones& human, const HandOptions& options);

/// A motion in the hand's own frame (in_hand_frame) with its fingers moved by the fit; distances
/// between them are `hand_scale` times what they were.
HumanMotion fitted_motion(HumanMotion motion, const HandFit& fit);

}  // namespace morphe::map
