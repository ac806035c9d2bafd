#include "stages/reconstruct/hand_shape.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/human/hand.hpp"
#include "core/math/rigid.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/hand_proportions.hpp"

namespace morphe::reconstruct {
namespace {

/// Returns the median of a number over the frames, NaN in frames without it; NaN if no frame has
/// it.
template <class Number>
double median_over(const std::vector<HandKeypoints>& frames, const Number& number) {
  std::vector<double> values;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double value = number(i);
    if (std::isfinite(value)) values.push_back(value);
  }
  return math::median(std::move(values));
}

/// Returns the median position of a point in the hand frame.
Vec3 median_place(const std::vector<HandKeypoints>& frames,
                  const std::vector<Eigen::Matrix3d>& axes, std::size_t point) {
  Vec3 place;
  for (Eigen::Index c = 0; c < 3; ++c) {
    place[c] = median_over(
        frames, [&](std::size_t i) { return axes[i].col(c).dot(frames[i][point] - frames[i][0]); });
  }
  return place;
}

/// Estimates the thumb's base by the proportions of Buchholz et al. (1992) from the rest of the
/// hand: on the line from the median position of its MCP to the base given by the proportions, at
/// the length of the metacarpal that corresponds to the thumb's other two bones.
void estimate_thumb_base(const Vec3& mcp, HandShape& shape) {
  const robot::ThumbProportions& thumb = robot::kThumbProportions;
  const double breadth = (shape.base[kIndex].y() - shape.base[kLittle].y()) /
                         (robot::kFingerProportions[kIndex - 1].across -
                          robot::kFingerProportions[kLittle - 1].across);
  const Vec3 usual(0, thumb.across * breadth, thumb.along * shape.length());
  auto& bones = shape.bone_lengths[kThumb];
  bones[0] = thumb.metacarpal / (thumb.proximal + thumb.distal) * (bones[1] + bones[2]);
  shape.base[kThumb] = mcp + bones[0] * (usual - mcp).normalized();
  shape.thumb_base_estimated = true;
}

}  // namespace

Eigen::Matrix3d hand_axes(const Vec3& to_fingers, const Vec3& to_thumb) {
  const Vec3 z = to_fingers.normalized();
  const Vec3 square = to_thumb - to_thumb.dot(z) * z;
  if (!(square.norm() > 1e-3 * to_thumb.norm()) || !(to_fingers.norm() > 0)) {
    return Eigen::Matrix3d::Constant(kUnknown);
  }
  const Vec3 y = square.normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

Eigen::Matrix3d hand_axes(const HandKeypoints& points) {
  return hand_axes(points[keypoint_index(kMiddle, 0)] - points[0],
                   points[keypoint_index(kIndex, 0)] - points[keypoint_index(kLittle, 0)]);
}

double HandShape::length() const {
  double length = base[kMiddle].norm();
  for (const double bone : bone_lengths[kMiddle]) length += bone;
  return length;
}

std::optional<HandShape> estimate_hand_shape(const std::vector<HandKeypoints>& frames) {
  std::vector<Eigen::Matrix3d> axes;
  for (const HandKeypoints& points : frames) axes.push_back(hand_axes(points));
  HandShape shape;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    shape.base[finger] = median_place(frames, axes, keypoint_index(finger, 0));
    for (std::size_t bone = 0; bone < 3; ++bone) {
      shape.bone_lengths[finger][bone] = median_over(frames, [&](std::size_t i) {
        return (frames[i][keypoint_index(finger, bone + 1)] -
                frames[i][keypoint_index(finger, bone)])
            .norm();
      });
    }
  }
  if (!is_known(shape.base[kThumb])) {
    estimate_thumb_base(median_place(frames, axes, keypoint_index(kThumb, 1)), shape);
  }
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    if (!is_known(shape.base[finger])) return std::nullopt;
    for (const double bone : shape.bone_lengths[finger]) {
      if (!(bone > 0)) return std::nullopt;
    }
  }
  return shape;
}

HandKeypoints enforce_finger_lengths(const HandShape& shape, const HandKeypoints& in_hand) {
  HandKeypoints kept;
  kept[0].setZero();
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    Vec3 here = shape.base[finger];
    kept[keypoint_index(finger, 0)] = here;
    std::size_t first = 0;
    if (finger == kThumb && shape.thumb_base_estimated) {
      kept[keypoint_index(finger, 1)] = here = in_hand[keypoint_index(finger, 1)];
      first = 1;
    }
    for (std::size_t bone = first; bone < 3; ++bone) {
      const std::size_t next = keypoint_index(finger, bone + 1);
      here += shape.bone_lengths[finger][bone] * (in_hand[next] - in_hand[next - 1]).normalized();
      kept[next] = here;
    }
  }
  return kept;
}

RobotModel make_hand_model(const HandShape& shape) {
  RobotModel hand = human::human_hand({1, 1});
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    // The lengths are set from the tip upwards: each distance between joints is a bone, the last
    // one that from the wrist.
    RobotModel::Tip& tip = hand.tips[finger];
    tip.transform.translation() =
        shape.bone_lengths[finger][2] * tip.transform.translation().normalized();
    std::size_t bone = 2;
    for (int frame = tip.frame; frame >= 0;) {
      RobotModel::Frame& here = hand.frames[frame];
      Eigen::Vector3d step = here.transform.translation();
      if (step.norm() > 0) {
        here.transform.translation() =
            bone > 0 ? Vec3(shape.bone_lengths[finger][bone - 1] * step.normalized())
                     : shape.base[finger];
        if (bone == 0) break;
        --bone;
      }
      frame = here.parent;
    }
  }
  return hand;
}

Eigen::Matrix3d fit_palm(const HandShape& shape, const HandKeypoints& points) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t finger = kIndex; finger < kFingerCount; ++finger) {
    covariance += (points[keypoint_index(finger, 0)] - points[0]) * shape.base[finger].transpose();
  }
  if (!covariance.allFinite()) return Eigen::Matrix3d::Constant(kUnknown);
  return math::nearest_rotation(covariance);
}

}  // namespace morphe::reconstruct
