#include "pipeline/study/held_objects.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/distance.hpp"
#include "core/human/hand.hpp"
#include "core/math/rotation.hpp"
#include "core/robot/hand_dimensions.hpp"

namespace morphe::study {
namespace {

constexpr int kMaxObjectDraws = 500;
constexpr double kMinWidth_m = 0.024, kMaxWidth_m = 0.080;
/// Cosine of the angle between the thumb's normal and the mean normal of the fingers.
constexpr double kMaxNormalCosine = -0.5;
/// Distance of the outermost contacts from an edge.
constexpr double kMinEdgeDistance_m = 0.008, kMaxEdgeDistance_m = 0.030;
constexpr int kTouchingFingers[] = {kThumb, kIndex, kMiddle};

/// A shape with its pose, and the inward normal at each of the three tips.
struct DrawnObject {
  Shape shape = Shape::sphere;
  std::vector<double> size;
  Pose world_from_object = Pose::Identity();
  std::array<Vec3, 3> normal;  ///< in the world frame
  double width_m = 0;
};

/// Returns the centre of the circle through three points. It is not finite if they are collinear.
Vec3 circle_centre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, normal = ab.cross(ac);
  return a + (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) /
                 (2 * normal.squaredNorm());
}

/// Returns axes x, y, z with the given z, rotated about it by an angle.
Eigen::Matrix3d axes_about(const Vec3& z, double angle_rad) {
  const Quat to_axis = math::shortest_rotation(Vec3::UnitZ(), z);
  return (to_axis * Eigen::AngleAxisd(angle_rad, Vec3::UnitZ())).toRotationMatrix();
}

DrawnObject draw_sphere(const std::array<Vec3, 3>& tips, double pad_depth_m,
                        math::RandomStream& random) {
  const Vec3 middle = circle_centre(tips[0], tips[1], tips[2]);
  const Vec3 normal = (tips[1] - tips[0]).cross(tips[2] - tips[0]).normalized();
  const Vec3 centre = middle + random.uniform(-0.3, 0.3) * (tips[0] - middle).norm() * normal;
  DrawnObject drawn{Shape::sphere,
                    {(tips[0] - centre).norm() - pad_depth_m},
                    make_pose(centre, random.rotation()),
                    {},
                    0};
  for (int k = 0; k < 3; ++k) drawn.normal[k] = (centre - tips[k]).normalized();
  drawn.width_m = 2 * drawn.size[0];
  return drawn;
}

/// The interval of the contacts along an axis, extended a little at both ends.
struct AxisRange {
  double from = 0, to = 0;
};
AxisRange draw_interval(const std::array<Vec3, 3>& tips, const Vec3& axis,
                        math::RandomStream& random) {
  const auto [low, high] = std::minmax({tips[0].dot(axis), tips[1].dot(axis), tips[2].dot(axis)});
  return {low - random.uniform(kMinEdgeDistance_m, kMaxEdgeDistance_m),
          high + random.uniform(kMinEdgeDistance_m, kMaxEdgeDistance_m)};
}

DrawnObject draw_cylinder(const std::array<Vec3, 3>& tips, double pad_depth_m,
                          math::RandomStream& random) {
  const Vec3 axis = random.rotation() * Vec3::UnitZ();
  const auto across = [&](const Vec3& point) -> Vec3 { return point - point.dot(axis) * axis; };
  const Vec3 centre = circle_centre(across(tips[0]), across(tips[1]), across(tips[2]));
  const AxisRange along = draw_interval(tips, axis, random);
  DrawnObject drawn;
  drawn.shape = Shape::cylinder;
  drawn.size = {(across(tips[0]) - centre).norm() - pad_depth_m, along.to - along.from};
  drawn.world_from_object.linear() = axes_about(axis, 0);
  drawn.world_from_object.translation() = centre + 0.5 * (along.from + along.to) * axis;
  for (int k = 0; k < 3; ++k) drawn.normal[k] = (centre - across(tips[k])).normalized();
  drawn.width_m = 2 * drawn.size[0];
  return drawn;
}

DrawnObject draw_box(const std::array<Vec3, 3>& tips, double pad_depth_m,
                     math::RandomStream& random) {
  const Vec3 along = (tips[2] - tips[1]).normalized();
  const Vec3 across = 0.5 * (tips[1] + tips[2]) - tips[0];
  const Vec3 normal = (across - across.dot(along) * along).normalized();
  DrawnObject drawn;
  drawn.shape = Shape::box;
  drawn.world_from_object.linear() = axes_about(normal, random.uniform(0, 2 * std::numbers::pi));
  const Vec3 x = drawn.world_from_object.linear().col(0),
             y = drawn.world_from_object.linear().col(1);
  const AxisRange on_x = draw_interval(tips, x, random), on_y = draw_interval(tips, y, random);
  const double thumb_face = tips[0].dot(normal) + pad_depth_m,
               finger_face = tips[1].dot(normal) - pad_depth_m;
  drawn.width_m = finger_face - thumb_face;
  drawn.size = {on_x.to - on_x.from, on_y.to - on_y.from, drawn.width_m};
  drawn.world_from_object.translation() = 0.5 * (on_x.from + on_x.to) * x +
                                          0.5 * (on_y.from + on_y.to) * y +
                                          0.5 * (thumb_face + finger_face) * normal;
  drawn.normal = {normal, -normal, -normal};
  return drawn;
}

SceneObject object_of(const DrawnObject& drawn) {
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
double lowest_point_m(const DrawnObject& drawn) {
  const Vec3 up = drawn.world_from_object.linear().row(2);  // the world's z in the object's frame
  const double centre_m = drawn.world_from_object.translation().z();
  if (drawn.shape == Shape::sphere) return centre_m - drawn.size[0];
  if (drawn.shape == Shape::box)
    return centre_m - 0.5 * up.cwiseAbs().dot(Vec3(drawn.size[0], drawn.size[1], drawn.size[2]));
  return centre_m - 0.5 * drawn.size[1] * std::abs(up.z()) - drawn.size[0] * up.head<2>().norm();
}

bool is_graspable(const DrawnObject& drawn, const std::vector<Vec3>& clear_points,
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

/// The person's hand, with the other points that must not lie in an object.
struct TrueHand {
  ObservedHand seen;
  std::vector<Vec3> other_points;
};

Pose world_from_hand(const Demonstration& truth, std::ptrdiff_t i) {
  const BodyStream& joints = *truth.streams.sensors;
  return make_pose(joints.position(i, 2), joints.orientation(i, 2));
}

TrueHand true_hand(const Demonstration& truth, std::ptrdiff_t i) {
  const RobotModel hand = human::human_hand({*truth.hand_length, *truth.hand_breadth});
  const auto row = truth.streams.arm_angles->angles.row(i);
  human::HandAngles angles;
  for (int k = 0; k < std::ssize(angles.joint); ++k) angles.joint[k] = row[kArmAngleCount + k];
  angles.palm_arch = row[kArmAngleCount + kHandAngleCount];
  std::vector<Pose> frames;
  const human::HandPoints points = human::hand_points(hand, angles, frames);
  const Pose from_hand = world_from_hand(truth, i);
  const HandBones bones = robot::hand_dimensions(hand);
  TrueHand result;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    result.seen.tip[finger] = truth.streams.hand->position(i, finger);
    result.seen.middle_joint[finger] = from_hand * points.middle_joint[finger];
    result.other_points.push_back(result.seen.middle_joint[finger]);
    result.other_points.push_back(from_hand * bones.knuckle[finger]);
    if (finger >= kRing) result.other_points.push_back(result.seen.tip[finger]);
  }
  std::erase_if(result.other_points, [](const Vec3& point) { return !morphe::is_known(point); });
  return result;
}

}  // namespace

std::optional<HeldObject> draw_held_object(Shape shape, const ObservedHand& hand,
                                           const std::vector<Vec3>& clear_points,
                                           double pad_depth_m, math::RandomStream& random) {
  const std::array<Vec3, 3> tips = {hand.tip[kThumb], hand.tip[kIndex], hand.tip[kMiddle]};
  for (int k = 0; k < kMaxObjectDraws; ++k) {
    const DrawnObject drawn = shape == Shape::sphere     ? draw_sphere(tips, pad_depth_m, random)
                              : shape == Shape::cylinder ? draw_cylinder(tips, pad_depth_m, random)
                                                         : draw_box(tips, pad_depth_m, random);
    if (!is_graspable(drawn, clear_points, pad_depth_m)) continue;
    HeldObject held{object_of(drawn), {}};
    const Pose object_from_world = drawn.world_from_object.inverse();
    for (int i = 0; i < 3; ++i) {
      const int finger = kTouchingFingers[i];
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
  const double grasp_s = 0.5 * (grasp->begin_s + grasp->end_s);
  const std::ptrdiff_t grasp_frame = std::ranges::lower_bound(time, grasp_s) - time.begin();
  const TrueHand hand = true_hand(truth, grasp_frame);
  std::optional<HeldObject> held =
      draw_held_object(shape, hand.seen, hand.other_points, pad_depth_m, random);
  if (!held) return std::nullopt;
  SceneObject moving = held->object;
  const Pose hand_from_object = world_from_hand(truth, grasp_frame).inverse() *
                                make_pose(held->object.position[0], held->object.orientation[0]);
  moving.time = time;
  moving.position.clear();
  moving.orientation.clear();
  for (int i = 0; i < std::ssize(time); ++i) {
    if (i <= grasp_frame) {
      moving.position.push_back(held->object.position[0]);
      moving.orientation.push_back(held->object.orientation[0]);
    } else if (time[i] <= back->begin_s) {
      const Pose pose = world_from_hand(truth, i) * hand_from_object;
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
