#include "stages/reconstruct/hand_shape.hpp"

#include <cmath>
#include <utility>

#include "core/human/hand.hpp"
#include "core/math/rigid.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/hand_proportions.hpp"

namespace morphe::reconstruct {
namespace {

/// Returns the median of number(frame) over the frames in which it is finite; NaN if it never is.
template <class Number>
double median_over(const std::vector<HandKeypoints>& frames, const Number& number) {
  std::vector<double> values;
  for (int i = 0; i < std::ssize(frames); ++i) {
    const double value = number(i);
    if (std::isfinite(value)) values.push_back(value);
  }
  return math::median(std::move(values));
}

Vec3 median_in_hand(const std::vector<HandKeypoints>& frames,
                    const std::vector<Eigen::Matrix3d>& axes, std::size_t point) {
  Vec3 median;
  for (int c = 0; c < 3; ++c) {
    median[c] = median_over(
        frames, [&](int i) { return axes[i].col(c).dot(frames[i][point] - frames[i][0]); });
  }
  return median;
}

/// Estimates the thumb's base by the proportions of Buchholz et al. (1992): on the line from the
/// MCP towards the base that they give, at a metacarpal's length for the thumb's other two bones.
void estimate_thumb_base(const Vec3& mcp, HandShape& shape) {
  const robot::ThumbProportions& thumb = robot::kThumbProportions;
  const double breadth = (shape.base[kIndex].y() - shape.base[kLittle].y()) /
                         (robot::kFingerProportions[kIndex - 1].across -
                          robot::kFingerProportions[kLittle - 1].across);
  const Vec3 typical_base(0, thumb.across * breadth, thumb.along * shape.length());
  auto& bones = shape.bone_lengths[kThumb];
  bones[0] = thumb.metacarpal / (thumb.proximal + thumb.distal) * (bones[1] + bones[2]);
  shape.base[kThumb] = mcp + bones[0] * (typical_base - mcp).normalized();
  shape.thumb_base_estimated = true;
}

}  // namespace

Eigen::Matrix3d hand_axes(const Vec3& to_fingers, const Vec3& to_thumb) {
  const Vec3 z = to_fingers.normalized();
  const Vec3 orthogonal = to_thumb - to_thumb.dot(z) * z;
  if (!(orthogonal.norm() > 1e-3 * to_thumb.norm()) || !(to_fingers.norm() > 0)) {
    return Eigen::Matrix3d::Constant(kUnknown);
  }
  const Vec3 y = orthogonal.normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

double HandShape::length() const {
  double length = base[kMiddle].norm();
  for (const double bone : bone_lengths[kMiddle]) length += bone;
  return length;
}

std::optional<HandShape> estimate_hand_shape(const std::vector<HandKeypoints>& frames) {
  std::vector<Eigen::Matrix3d> axes;
  for (const HandKeypoints& points : frames) {
    const auto knuckle = [&](std::size_t finger) { return points[keypoint_index(finger, 0)]; };
    axes.push_back(hand_axes(knuckle(kMiddle) - points[0], knuckle(kIndex) - knuckle(kLittle)));
  }
  HandShape shape;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    shape.base[finger] = median_in_hand(frames, axes, keypoint_index(finger, 0));
    for (int bone = 0; bone < 3; ++bone) {
      const std::size_t from = keypoint_index(finger, bone);
      shape.bone_lengths[finger][bone] = median_over(
          frames, [&](int i) { return (frames[i][from + 1] - frames[i][from]).norm(); });
    }
  }
  if (!is_known(shape.base[kThumb])) {
    estimate_thumb_base(median_in_hand(frames, axes, keypoint_index(kThumb, 1)), shape);
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
    Vec3 joint = shape.base[finger];
    kept[keypoint_index(finger, 0)] = joint;
    int first = 0;
    if (finger == kThumb && shape.thumb_base_estimated) {
      kept[keypoint_index(finger, 1)] = joint = in_hand[keypoint_index(finger, 1)];
      first = 1;
    }
    for (int bone = first; bone < 3; ++bone) {
      const std::size_t next = keypoint_index(finger, bone + 1);
      joint += shape.bone_lengths[finger][bone] * (in_hand[next] - in_hand[next - 1]).normalized();
      kept[next] = joint;
    }
  }
  return kept;
}

RobotModel make_hand_model(const HandShape& shape) {
  RobotModel hand = human::human_hand({1, 1});
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    // From the tip to the wrist, each distance between joints is a bone; the last ends at the base.
    const auto& bones = shape.bone_lengths[finger];
    RobotModel::Tip& tip = hand.tips[finger];
    tip.transform.translation() = bones[2] * tip.transform.translation().normalized();
    int bone = 2;
    for (int frame = tip.frame; frame >= 0 && bone >= 0; frame = hand.frames[frame].parent) {
      auto step = hand.frames[frame].transform.translation();
      if (!(step.norm() > 0)) continue;
      --bone;
      step = bone >= 0 ? Vec3(bones[bone] * step.normalized()) : shape.base[finger];
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
