#include "stages/map/hand_alignment.hpp"

#include <algorithm>
#include <vector>

namespace morphe::map {
namespace {

/// Returns the fingers that both hands have, without the thumb.
std::vector<std::size_t> common_fingers(const HandBones& robot, const HandBones& human) {
  std::vector<std::size_t> fingers;
  for (std::size_t f = kIndex; f < kFingerCount; ++f) {
    if (robot.length[f] > 0 && human.length[f] > 0) fingers.push_back(f);
  }
  return fingers;
}

}  // namespace

std::string validation_error(const HandOptions& options) {
  if (options.scale != HandScale::fixed && options.factor != 1) {
    return "factor must be 1 unless scale is fixed";
  }
  return "";
}

HandAlignment align_hand(const HandBones& robot, const HandBones& human,
                         const HandOptions& options) {
  HandAlignment fit;
  fit.scale = options.factor;
  const bool knuckles = options.align == HandAlignmentPoint::knuckles;
  if (options.scale == HandScale::fixed && !knuckles) return fit;
  const std::vector<std::size_t> fingers = common_fingers(robot, human);
  if (fingers.empty()) {
    fit.problem = "the lengths of the person's fingers are unknown: the hand is not scaled";
    return fit;
  }
  if (options.scale == HandScale::finger_length) {
    fit.scale = kInfinity;
    for (const std::size_t f : fingers) {
      fit.scale = std::min(fit.scale, robot.length[f] / human.length[f]);
    }
  } else if (options.scale == HandScale::palm_breadth) {
    if (fingers.size() < 2) {
      fit.problem = "one finger gives no hand breadth: the hand is not scaled";
      return fit;
    }
    const auto breadth = [&](const HandBones& hand) {
      return (hand.knuckle[fingers.front()] - hand.knuckle[fingers.back()]).norm();
    };
    fit.scale = breadth(robot) / breadth(human);
  }
  if (knuckles) {
    for (const auto f : fingers) fit.offset += robot.knuckle[f] - fit.scale * human.knuckle[f];
    fit.offset /= static_cast<double>(fingers.size());
  }
  return fit;
}

HumanMotion apply_alignment(HumanMotion motion, const HandAlignment& fit) {
  for (Array2D<Vec3>* points : {&motion.tip, &motion.finger_joint}) {
    for (Vec3& point : points->values) point = fit.scale * point + fit.offset;
  }
  motion.hand_scale *= fit.scale;
  return motion;
}

}  // namespace morphe::map
