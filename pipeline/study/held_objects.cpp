#include "pipeline/study/held_objects.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/distance.hpp"
#include "core/human/hand.hpp"
#include "core/math/rotation.hpp"
#include "core/robot/hand_bones.hpp"

namespace morphe::study {
namespace {

constexpr int kTriesToHold = 500;
constexpr double kNarrowest_m = 0.024, kWidest_m = 0.080;
constexpr double kOpposed = -0.5;  ///< cosine between the thumb's normal and the fingers' mean
constexpr double kLeastEdge_m = 0.008, kMostEdge_m = 0.030;  ///< from a contact to an edge
constexpr std::size_t kTouching[] = {kThumb, kIndex, kMiddle};

/// A shape with its place, and the inward normal at each of the three tips.
struct Drawn {
  Shape shape = Shape::sphere;
  std::vector<double> size;
  Pose world_from_object = Pose::Identity();
  std::array<Vec3, 3> normal;  ///< in the world
  double width_m = 0;
};

/// Centre of the circle through three points; not finite if they lie on one line.
Vec3 circle_centre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, normal = ab.cross(ac);
  return a + (ac.squaredNorm() * normal.cross(ab) + ab.squaredNorm() * ac.cross(normal)) /
                 (2 * normal.squaredNorm());
}

/// Axes x, y, z of which z (or x) is given, turned about it by an angle.
Eigen::Matrix3d axes_about(const Vec3& axis, double angle_rad) {
  const Quat to_axis = math::shortest_rotation(Vec3::UnitZ(), axis);
  return (to_axis * Eigen::AngleAxisd(angle_rad, Vec3::UnitZ())).toRotationMatrix();
}

Drawn draw_sphere(const std::array<Vec3, 3>& tips, double pad_depth_m, math::RandomStream& random) {
  const Vec3 middle = circle_centre(tips[0], tips[1], tips[2]);
  const Vec3 aside = (tips[1] - tips[0]).cross(tips[2] - tips[0]).normalized();
  const Vec3 centre = middle + random.uniform(-0.3, 0.3) * (tips[0] - middle).norm() * aside;
  Drawn drawn{Shape::sphere,
              {(tips[0] - centre).norm() - pad_depth_m},
              make_pose(centre, random.rotation()),
              {},
              0};
  for (std::size_t k = 0; k < 3; ++k) drawn.normal[k] = (centre - tips[k]).normalized();
  drawn.width_m = 2 * drawn.size[0];
  return drawn;
}

/// From the lowest to the highest of the contacts along an axis, and a bit beyond on either side.
struct Extent {
  double from = 0, to = 0;
};
Extent draw_extent(const std::array<Vec3, 3>& tips, const Vec3& axis, math::RandomStream& random) {
  const auto [least, most] = std::minmax({tips[0].dot(axis), tips[1].dot(axis), tips[2].dot(axis)});
  return {least - random.uniform(kLeastEdge_m, kMostEdge_m),
          most + random.uniform(kLeastEdge_m, kMostEdge_m)};
}

Drawn draw_cylinder(const std::array<Vec3, 3>& tips, double pad_depth_m,
                    math::RandomStream& random) {
  const Vec3 axis = random.rotation() * Vec3::UnitZ();
  const auto across = [&](const Vec3& point) -> Vec3 { return point - point.dot(axis) * axis; };
  const Vec3 centre = circle_centre(across(tips[0]), across(tips[1]), across(tips[2]));
  const Extent along = draw_extent(tips, axis, random);
  Drawn drawn;
  drawn.shape = Shape::cylinder;
  drawn.size = {(across(tips[0]) - centre).norm() - pad_depth_m, along.to - along.from};
  drawn.world_from_object.linear() = axes_about(axis, 0);
  drawn.world_from_object.translation() = centre + 0.5 * (along.from + along.to) * axis;
  for (std::size_t k = 0; k < 3; ++k) drawn.normal[k] = (centre - across(tips[k])).normalized();
  drawn.width_m = 2 * drawn.size[0];
  return drawn;
}

Drawn draw_box(const std::array<Vec3, 3>& tips, double pad_depth_m, math::RandomStream& random) {
  const Vec3 between = (tips[2] - tips[1]).normalized();
  const Vec3 over = 0.5 * (tips[1] + tips[2]) - tips[0];
  const Vec3 normal = (over - over.dot(between) * between).normalized();
  Drawn drawn;
  drawn.shape = Shape::box;
  drawn.world_from_object.linear() = axes_about(normal, random.uniform(0, 2 * std::numbers::pi));
  const Vec3 x = drawn.world_from_object.linear().col(0),
             y = drawn.world_from_object.linear().col(1);
  const Extent wide = draw_extent(tips, x, random), high = draw_extent(tips, y, random);
  const double near = tips[0].dot(normal) + pad_depth_m, far = tips[1].dot(normal) - pad_depth_m;
  drawn.width_m = far - near;
  drawn.size = {wide.to - wide.from, high.to - high.from, drawn.width_m};
  drawn.world_from_object.translation() = 0.5 * (wide.from + wide.to) * x +
                                          0.5 * (high.from + high.to) * y +
                                          0.5 * (near + far) * normal;
  drawn.normal = {normal, -normal, -normal};
  return drawn;
}

SceneObject object_of(const Drawn& drawn) {
  SceneObject object;
  object.name = kHeldName;
  object.shape = drawn.shape;
  object.size = drawn.size;
  object.time = {0};
  object.position = {drawn.world_from_object.translation()};
  object.orientation = {Quat(drawn.world_from_object.linear())};
  return object;
}

/// Height of its lowest point.
double foot_m(const Drawn& drawn) {
  const Vec3 up = drawn.world_from_object.linear().row(2);  // the world's z in its own frame
  const double centre_m = drawn.world_from_object.translation().z();
  if (drawn.shape == Shape::sphere) return centre_m - drawn.size[0];
  if (drawn.shape == Shape::box) {
    return centre_m - 0.5 * up.cwiseAbs().dot(Vec3(drawn.size[0], drawn.size[1], drawn.size[2]));
  }
  return centre_m - 0.5 * drawn.size[1] * std::abs(up.z()) - drawn.size[0] * up.head<2>().norm();
}

bool can_be_grasped(const Drawn& drawn, const std::vector<Vec3>& clear_points, double pad_depth_m) {
  if (!(drawn.width_m >= kNarrowest_m && drawn.width_m <= kWidest_m)) return false;
  const Vec3 fingers = (drawn.normal[1] + drawn.normal[2]).normalized();
  if (!(drawn.normal[0].dot(fingers) <= kOpposed) || !(foot_m(drawn) >= 0)) return false;
  const SceneObject object = object_of(drawn);
  const Pose object_from_world = drawn.world_from_object.inverse();
  return std::ranges::all_of(clear_points, [&](const Vec3& point) {
    Vec3 gradient;
    return collision::signed_distance(object, object_from_world * point, gradient) >= pad_depth_m;
  });
}

/// The person's hand at sample i of the truth, and what else of it must not lie in an object.
struct TrueHand {
  SeenHand seen;
  std::vector<Vec3> elsewhere;
};

Pose world_from_hand(const Demonstration& truth, std::size_t i) {
  const BodyStream& joints = *truth.streams.sensors;
  return make_pose(joints.position(i, 2), joints.orientation(i, 2));
}

TrueHand true_hand(const Demonstration& truth, std::size_t i) {
  const RobotTable hand = human::human_hand({*truth.hand_length, *truth.hand_breadth});
  const auto row = truth.streams.arm_angles->angles.row(static_cast<Eigen::Index>(i));
  human::HandAngles angles;
  for (std::size_t k = 0; k < kHandAngles; ++k) {
    angles.joint[k] = row[static_cast<Eigen::Index>(kArmAngles + k)];
  }
  angles.palm_arch = row[static_cast<Eigen::Index>(kArmAngles + kHandAngles)];
  std::vector<Pose> frames;
  const human::HandPoints points = human::hand_points(hand, angles, frames);
  const Pose world = world_from_hand(truth, i);
  const HandBones bones = robot::hand_bones(hand);
  TrueHand result;
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    result.seen.tip[finger] = truth.streams.hand->position(i, finger);
    result.seen.middle_joint[finger] = world * points.middle_joint[finger];
    result.elsewhere.push_back(result.seen.middle_joint[finger]);
    result.elsewhere.push_back(world * bones.knuckle[finger]);
    if (finger >= kRing) result.elsewhere.push_back(result.seen.tip[finger]);
  }
  std::erase_if(result.elsewhere, [](const Vec3& point) { return !morphe::seen(point); });
  return result;
}

}  // namespace

std::optional<HeldObject> hold_object(Shape shape, const SeenHand& hand,
                                      const std::vector<Vec3>& clear_points, double pad_depth_m,
                                      math::RandomStream& random) {
  const std::array<Vec3, 3> tips = {hand.tip[kThumb], hand.tip[kIndex], hand.tip[kMiddle]};
  for (int k = 0; k < kTriesToHold; ++k) {
    const Drawn drawn = shape == Shape::sphere     ? draw_sphere(tips, pad_depth_m, random)
                        : shape == Shape::cylinder ? draw_cylinder(tips, pad_depth_m, random)
                                                   : draw_box(tips, pad_depth_m, random);
    if (!can_be_grasped(drawn, clear_points, pad_depth_m)) continue;
    HeldObject held{object_of(drawn), {}};
    const Pose object_from_world = drawn.world_from_object.inverse();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t finger = kTouching[i];
      held.contacts.push_back(
          {finger, object_from_world * (tips[i] + pad_depth_m * drawn.normal[i]),
           object_from_world.linear() * drawn.normal[i], object_from_world * tips[i],
           object_from_world * hand.middle_joint[finger]});
    }
    return held;
  }
  return std::nullopt;
}

std::optional<KnownGrasp> known_grasp(const synthesize::SyntheticRecording& recording, Shape shape,
                                      double pad_depth_m, math::RandomStream& random) {
  const Demonstration& truth = recording.truth;
  const auto label = [&](PhaseKind phase) {
    return std::ranges::find(truth.labels, phase, &Label::phase);
  };
  const auto grasp = label(PhaseKind::grasp), back = label(PhaseKind::go_back);
  if (grasp == truth.labels.end() || back == truth.labels.end()) return std::nullopt;
  const std::vector<double>& time = truth.streams.sensors->time;
  const double taken_s = 0.5 * (grasp->begin_s + grasp->end_s);
  const auto taken =
      static_cast<std::size_t>(std::ranges::lower_bound(time, taken_s) - time.begin());
  const TrueHand hand = true_hand(truth, taken);
  std::optional<HeldObject> held =
      hold_object(shape, hand.seen, hand.elsewhere, pad_depth_m, random);
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
