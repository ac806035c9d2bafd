#include "pipeline/study/held_objects.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/distance.hpp"
#include "core/human/hand.hpp"
#include "core/math/rotation.hpp"
#include "core/robot/hand_dimensions.hpp"

namespace morphe::study {
namespace {

constexpr int kMaxObjectSamples = 500;
constexpr double kMinWidth_m = 0.024, kMaxWidth_m = 0.080;
/// Cosine between the thumb's normal and the mean normal of the fingers.
constexpr double kMaxNormalCosine = -0.5;
constexpr double kMinEdgeDistance_m = 0.008,
                 kMaxEdgeDistance_m = 0.030;  ///< distance of a contact from an edge
constexpr std::size_t kTouchingFingers[] = {kThumb, kIndex, kMiddle};

/// A shape with its pose, and the inward normal at each of the three tips.
struct SampledObject {
  Shape shape = Shape::sphere;
  std::vector<double> size;
  Pose world_from_object = Pose::Identity();
  std::array<Vec3, 3> normal;  ///< in the world frame
  double width_m = 0;
};

/// Computes the centre of the circle through three points. It is not finite if they are collinear.
Vec3 circle_centre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, normal = ab.cross(ac);
  return a + (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) /
                 (2 * normal.squaredNorm());
}

/// Returns axes x, y, z with the given z (or x), rotated about it by an angle.
Eigen::Matrix3d axes_about(const Vec3& axis, double angle_rad) {
  const Quat to_axis = math::shortest_rotation(Vec3::UnitZ(), axis);
  return (to_axis * Eigen::AngleAxisd(angle_rad, Vec3::UnitZ())).toRotationMatrix();
}

SampledObject sample_sphere(const std::array<Vec3, 3>& tips, double pad_depth_m,
                            math::RandomStream& random) {
  const Vec3 middle = circle_centre(tips[0], tips[1], tips[2]);
  const Vec3 aside = (tips[1] - tips[0]).cross(tips[2] - tips[0]).normalized();
  const Vec3 centre = middle + random.uniform(-0.3, 0.3) * (tips[0] - middle).norm() * aside;
  SampledObject drawn{Shape::sphere,
                      {(tips[0] - centre).norm() - pad_depth_m},
                      make_pose(centre, random.rotation()),
                      {},
                      0};
  for (std::size_t k = 0; k < 3; ++k) drawn.normal[k] = (centre - tips[k]).normalized();
  drawn.width_m = 2 * drawn.size[0];
  return drawn;
}

/// The interval of the contacts along an axis, extended a little at both ends.
struct AxisRange {
  double from = 0, to = 0;
};
AxisRange sample_interval(const std::array<Vec3, 3>& tips, const Vec3& axis,
                          math::RandomStream& random) {
  const auto [least, most] = std::minmax({tips[0].dot(axis), tips[1].dot(axis), tips[2].dot(axis)});
  return {least - random.uniform(kMinEdgeDistance_m, kMaxEdgeDistance_m),
          most + random.uniform(kMinEdgeDistance_m, kMaxEdgeDistance_m)};
}

SampledObject sample_cylinder(const std::array<Vec3, 3>& tips, double pad_depth_m,
                              math::RandomStream& random) {
  const Vec3 axis = random.rotation() * Vec3::UnitZ();
  const auto across = [&](const Vec3& point) -> Vec3 { return point - point.dot(axis) * axis; };
  const Vec3 centre = circle_centre(across(tips[0]), across(tips[1]), across(tips[2]));
  const AxisRange along = sample_interval(tips, axis, random);
  SampledObject drawn;
  drawn.shape = Shape::cylinder;
  drawn.size = {(across(tips[0]) - centre).norm() - pad_depth_m, along.to - along.from};
  drawn.world_from_object.linear() = axes_about(axis, 0);
  drawn.world_from_object.translation() = centre + 0.5 * (along.from + along.to) * axis;
  for (std::size_t k = 0; k < 3; ++k) drawn.normal[k] = (centre - across(tips[k])).normalized();
  drawn.width_m = 2 * drawn.size[0];
  return drawn;
}

SampledObject sample_box(const std::array<Vec3, 3>& tips, double pad_depth_m,
                         math::RandomStream& random) {
  const Vec3 between = (tips[2] - tips[1]).normalized();
  const Vec3 over = 0.5 * (tips[1] + tips[2]) - tips[0];
  const Vec3 normal = (over - over.dot(between) * between).normalized();
  SampledObject drawn;
  drawn.shape = Shape::box;
  drawn.world_from_object.linear() = axes_about(normal, random.uniform(0, 2 * std::numbers::pi));
  const Vec3 x = drawn.world_from_object.linear().col(0),
             y = drawn.world_from_object.linear().col(1);
  const AxisRange wide = sample_interval(tips, x, random), high = sample_interval(tips, y, random);
  const double near = tips[0].dot(normal) + pad_depth_m, far = tips[1].dot(normal) - pad_depth_m;
  drawn.width_m = far - near;
  drawn.size = {wide.to - wide.from, high.to - high.from, drawn.width_m};
  drawn.world_from_object.translation() = 0.5 * (wide.from + wide.to) * x +
                                          0.5 * (high.from + high.to) * y +
                                          0.5 * (near + far) * normal;
  drawn.normal = {normal, -normal, -normal};
  return drawn;
}

SceneObject object_of(const SampledObject& drawn) {
  SceneObject object;
  object.name = kHeldObjectName;
  object.shape = drawn.shape;
  object.size = drawn.size;
  object.time = {0};
  object.position = {drawn.world_from_object.translation()};
  object.orientation = {Quat(drawn.world_from_object.linear())};
  return object;
}

/// Returns the height of the lowest point [m].
double lowest_point_m(const SampledObject& drawn) {
  const Vec3 up =
      drawn.world_from_object.linear().row(2);  // the world's z axis in the frame of the object
  const double centre_m = drawn.world_from_object.translation().z();
  if (drawn.shape == Shape::sphere) return centre_m - drawn.size[0];
  if (drawn.shape == Shape::box) {
    return centre_m - 0.5 * up.cwiseAbs().dot(Vec3(drawn.size[0], drawn.size[1], drawn.size[2]));
  }
  return centre_m - 0.5 * drawn.size[1] * std::abs(up.z()) - drawn.size[0] * up.head<2>().norm();
}

bool is_graspable(const SampledObject& drawn, const std::vector<Vec3>& clear_points,
                  double pad_depth_m) {
  if (!(drawn.width_m >= kMinWidth_m && drawn.width_m <= kMaxWidth_m)) return false;
  const Vec3 fingers = (drawn.normal[1] + drawn.normal[2]).normalized();
  if (!(drawn.normal[0].dot(fingers) <= kMaxNormalCosine) || !(lowest_point_m(drawn) >= 0))
    return false;
  const SceneObject object = object_of(drawn);
  const Pose object_from_world = drawn.world_from_object.inverse();
  return std::ranges::all_of(clear_points, [&](const Vec3& point) {
    Vec3 gradient;
    return collision::signed_distance(object, object_from_world * point, gradient) >= pad_depth_m;
  });
}

/// The person's hand at sample i of the ground truth, with the further points that must not lie in
/// an object.
struct TrueHand {
  ObservedHand seen;
  std::vector<Vec3> other_points;
};

Pose world_from_hand(const Demonstration& truth, std::size_t i) {
  const BodyStream& joints = *truth.streams.sensors;
  return make_pose(joints.position(i, 2), joints.orientation(i, 2));
}

TrueHand true_hand(const Demonstration& truth, std::size_t i) {
  const RobotModel hand = human::human_hand({*truth.hand_length, *truth.hand_breadth});
  const auto row = truth.streams.arm_angles->angles.row(i);
  human::HandAngles angles;
  for (std::size_t k = 0; k < kHandAngleCount; ++k) {
    angles.joint[k] = row[kArmAngleCount + k];
  }
  angles.palm_arch = row[kArmAngleCount + kHandAngleCount];
  std::vector<Pose> frames;
  const human::HandPoints points = human::hand_points(hand, angles, frames);
  const Pose world = world_from_hand(truth, i);
  const HandBones bones = robot::hand_dimensions(hand);
  TrueHand result;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    result.seen.tip[finger] = truth.streams.hand->position(i, finger);
    result.seen.middle_joint[finger] = world * points.middle_joint[finger];
    result.other_points.push_back(result.seen.middle_joint[finger]);
    result.other_points.push_back(world * bones.knuckle[finger]);
    if (finger >= kRing) result.other_points.push_back(result.seen.tip[finger]);
  }
  std::erase_if(result.other_points, [](const Vec3& point) { return !morphe::is_known(point); });
  return result;
}

}  // namespace

std::optional<HeldObject> sample_held_object(Shape shape, const ObservedHand& hand,
                                             const std::vector<Vec3>& clear_points,
                                             double pad_depth_m, math::RandomStream& random) {
  const std::array<Vec3, 3> tips = {hand.tip[kThumb], hand.tip[kIndex], hand.tip[kMiddle]};
  for (int k = 0; k < kMaxObjectSamples; ++k) {
    const SampledObject drawn = shape == Shape::sphere ? sample_sphere(tips, pad_depth_m, random)
                                : shape == Shape::cylinder
                                    ? sample_cylinder(tips, pad_depth_m, random)
                                    : sample_box(tips, pad_depth_m, random);
    if (!is_graspable(drawn, clear_points, pad_depth_m)) continue;
    HeldObject held{object_of(drawn), {}};
    const Pose object_from_world = drawn.world_from_object.inverse();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t finger = kTouchingFingers[i];
      held.contacts.push_back(
          {finger, object_from_world * (tips[i] + pad_depth_m * drawn.normal[i]),
           object_from_world.linear() * drawn.normal[i], object_from_world * tips[i],
           object_from_world * hand.middle_joint[finger]});
    }
    return held;
  }
  return std::nullopt;
}

std::optional<KnownGrasp> add_held_object(const synthesize::SyntheticRecording& recording,
                                          Shape shape, double pad_depth_m,
                                          math::RandomStream& random) {
  const Demonstration& truth = recording.truth;
  const auto label = [&](PhaseKind phase) {
    return std::ranges::find(truth.labels, phase, &Label::phase);
  };
  const auto grasp = label(PhaseKind::grasp), back = label(PhaseKind::return_phase);
  if (grasp == truth.labels.end() || back == truth.labels.end()) return std::nullopt;
  const std::vector<double>& time = truth.streams.sensors->time;
  const double taken_s = 0.5 * (grasp->begin_s + grasp->end_s);
  const auto taken =
      static_cast<std::size_t>(std::ranges::lower_bound(time, taken_s) - time.begin());
  const TrueHand hand = true_hand(truth, taken);
  std::optional<HeldObject> held =
      sample_held_object(shape, hand.seen, hand.other_points, pad_depth_m, random);
  if (!held) return std::nullopt;
  SceneObject moving = held->object;
  const Pose in_hand = world_from_hand(truth, taken).inverse() *
                       make_pose(held->object.position[0], held->object.orientation[0]);
  moving.time = time;
  moving.position.clear();
  moving.orientation.clear();
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (i <= taken) {
      moving.position.push_back(held->object.position[0]);
      moving.orientation.push_back(held->object.orientation[0]);
    } else if (time[i] <= back->begin_s) {
      const Pose pose = world_from_hand(truth, i) * in_hand;
      moving.position.emplace_back(pose.translation());
      moving.orientation.emplace_back(pose.linear());
    } else {
      moving.position.push_back(Vec3(moving.position.back()));
      moving.orientation.push_back(Quat(moving.orientation.back()));
    }
  }
  KnownGrasp known{recording.recorded, std::move(held->contacts)};
  known.recorded.objects = {std::move(moving)};
  return known;
}

}  // namespace morphe::study
