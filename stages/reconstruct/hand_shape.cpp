#include "stages/reconstruct/hand_shape.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/human/hand.hpp"
#include "pipeline/math/rigid.hpp"
#include "pipeline/math/statistics.hpp"

namespace morphe::reconstruct {
namespace {

/// Median of a number that each frame gives, NaN where it does not; NaN if none does.
template <class Number>
double median_over(const std::vector<HandKeypoints>& frames, const Number& number) {
  std::vector<double> values;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double value = number(i);
    if (std::isfinite(value)) values.push_back(value);
  }
  return values.empty() ? kNotSeen : math::median(values);
}

}  // namespace

Eigen::Matrix3d hand_axes(const Vec3& to_fingers, const Vec3& to_thumb) {
  const Vec3 z = to_fingers.normalized();
  const Vec3 square = to_thumb - to_thumb.dot(z) * z;
  if (!(square.norm() > 1e-3 * to_thumb.norm()) || !(to_fingers.norm() > 0)) {
    return Eigen::Matrix3d::Constant(kNotSeen);
  }
  const Vec3 y = square.normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(z), y, z;
  return axes;
}

Eigen::Matrix3d hand_axes(const HandKeypoints& points) {
  return hand_axes(points[keypoint_of(kMiddle, 0)] - points[0],
                   points[keypoint_of(kIndex, 0)] - points[keypoint_of(kLittle, 0)]);
}

double HandShape::length() const {
  double length = base[kMiddle].norm();
  for (const double bone : bones[kMiddle]) length += bone;
  return length;
}

std::optional<HandShape> median_hand(const std::vector<HandKeypoints>& frames) {
  std::vector<Eigen::Matrix3d> axes;
  for (const HandKeypoints& points : frames) axes.push_back(hand_axes(points));
  HandShape shape;
  bool whole = true;
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      shape.base[finger][c] = median_over(frames, [&](std::size_t i) {
        return axes[i].col(c).dot(frames[i][keypoint_of(finger, 0)] - frames[i][0]);
      });
      whole = whole && std::isfinite(shape.base[finger][c]);
    }
    for (std::size_t bone = 0; bone < 3; ++bone) {
      shape.bones[finger][bone] = median_over(frames, [&](std::size_t i) {
        return (frames[i][keypoint_of(finger, bone + 1)] - frames[i][keypoint_of(finger, bone)])
            .norm();
      });
      whole = whole && shape.bones[finger][bone] > 0;
    }
  }
  return whole ? std::optional(shape) : std::nullopt;
}

HandKeypoints keep_bones(const HandShape& shape, const HandKeypoints& in_hand) {
  HandKeypoints kept;
  kept[0].setZero();
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    Vec3 here = shape.base[finger];
    kept[keypoint_of(finger, 0)] = here;
    for (std::size_t bone = 0; bone < 3; ++bone) {
      const std::size_t next = keypoint_of(finger, bone + 1);
      here += shape.bones[finger][bone] * (in_hand[next] - in_hand[next - 1]).normalized();
      kept[next] = here;
    }
  }
  return kept;
}

RobotTable hand_of_shape(const HandShape& shape) {
  RobotTable hand = human::human_hand({1, 1});
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    // Up the chain from the tip: what has a length is a bone, the last one the way from the wrist.
    RobotTable::Tip& tip = hand.tips[finger];
    tip.transform.translation() = shape.bones[finger][2] * tip.transform.translation().normalized();
    std::size_t bone = 2;
    for (int frame = tip.frame; frame >= 0;) {
      RobotTable::Frame& here = hand.frames[static_cast<std::size_t>(frame)];
      Eigen::Vector3d step = here.transform.translation();
      if (step.norm() > 0) {
        here.transform.translation() =
            bone > 0 ? Vec3(shape.bones[finger][bone - 1] * step.normalized()) : shape.base[finger];
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
  for (std::size_t finger = kIndex; finger < kFingers; ++finger) {
    covariance += (points[keypoint_of(finger, 0)] - points[0]) * shape.base[finger].transpose();
  }
  if (!covariance.allFinite()) return Eigen::Matrix3d::Constant(kNotSeen);
  return math::nearest_rotation(covariance);
}

}  // namespace morphe::reconstruct
