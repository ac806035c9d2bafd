#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/motion/hand_bones.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::map {

/// The rule for scaling the human's hand if the robot is a hand alone:
///   fixed          scaled by `factor`
///   palm_breadth   scaled to the robot's breadth over the knuckles
///   finger_length  as large as possible with no finger longer, from knuckle to tip, than the
///   robot's
enum class HandScale { fixed, palm_breadth, finger_length };
/// Returns the names of the rules in configurations.
constexpr std::array<std::string_view, 3> names_of(HandScale) {
  return {"fixed", "palm_breadth", "finger_length"};
}

/// The points at which the hands are aligned: the human's wrist at the robot's palm, or the human's
/// knuckles at the robot's. The latter is the same for every choice of the palm's origin.
enum class HandAlignmentPoint { palm, knuckles };
/// Returns the names of the points in configurations.
constexpr std::array<std::string_view, 2> names_of(HandAlignmentPoint) {
  return {"palm", "knuckles"};
}

/// Options for robots without an arm (config section `hand`).
struct HandOptions {
  HandScale scale = HandScale::fixed;
  double factor = 1;  ///< the scale if it is `fixed`; otherwise 1
  HandAlignmentPoint align = HandAlignmentPoint::palm;
};
template <class Fields>
void fields(Fields& f, HandOptions& o) {
  f("scale", o.scale);
  f("factor", o.factor, bounds::kFactor);
  f("align", o.align);
}
/// Returns a sentence about the first invalid option, or "" if all are valid.
std::string validation_error(const HandOptions& options);

/// The transform palm_from_human: p -> scale * p + offset, both in their hand's own axes.
struct HandAlignment {
  double scale = 1;
  Vec3 offset = Vec3::Zero();  ///< [m]
  std::string problem;  ///< sentence about the data that the alignment lacks; "" if it is possible
};

/// Computes the alignment from the fingers that both hands have, without the thumb. If these are
/// too few for the options, `problem` says so, the scale is `factor` and the offset zero.
///   finger_length  scale = least ratio of the robot's to the human's finger lengths
///   palm_breadth   scale = ratio of the robot's to the human's distance of the outermost knuckles
///   offset = mean of (robot's knuckle - scale * human's)                  (align: knuckles)
HandAlignment align_hand(const HandBones& robot, const HandBones& human,
                         const HandOptions& options);

/// Applies the alignment to the fingers of a motion in the hand's own frame
/// (transform_to_hand_frame), and multiplies `hand_scale` by the scale.
HumanMotion apply_alignment(HumanMotion motion, const HandAlignment& fit);

}  // namespace morphe::map
