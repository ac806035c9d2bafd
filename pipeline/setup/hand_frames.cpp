#include "pipeline/setup/hand_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/input_error.hpp"
#include "core/robot/hand_proportions.hpp"
#include "pipeline/setup/finger_bodies.hpp"
#include "pipeline/setup/gripper_pads.hpp"

namespace morphe::setup {
namespace {

constexpr double kHumanFingerLength_m = 0.103;  ///< Buchholz 1992, middle finger from its knuckle
constexpr double kHumanHandLength_m = 0.19;

/// Returns the mean of the points within kEndDepth_m of the farthest one along a direction.
Vec3 farthest_point_along(const std::vector<Vec3>& points, const Vec3& direction) {
  constexpr double kEndDepth_m = 0.003;
  double farthest = -HUGE_VAL;
  for (const Vec3& point : points) farthest = std::max(farthest, point.dot(direction));
  std::vector<Vec3> end;
  for (const Vec3& point : points)
    if (point.dot(direction) > farthest - kEndDepth_m) end.push_back(point);
  return mean_of(end);
}

/// Returns the point twice as far from the axis as the centre of mass; the joint's without inertia.
Vec3 fingertip_from_inertia(const Kinematics& robot, int last, const Line& axis) {
  const auto inertia = robot.model->inertias.find(robot.link[last]);
  if (inertia == robot.model->inertias.end()) return robot.pose(last).translation();
  const Vec3 centre = robot.pose(last) * inertia->second.link_from_inertia.translation();
  return project_onto_line(axis, centre) +
         2 * perpendicular_part(centre - project_onto_line(axis, centre), axis.direction);
}

/// Returns the direction of a last bone of which only the joint is known: that of the bone
/// before it, perpendicular to its axis. Throws InputError if that is along the axis.
Vec3 bone_before(const Kinematics& robot, const Hand& hand, const Finger& finger,
                 const Line& axis) {
  constexpr double kShortest_m = 0.005;
  std::vector<int> before(finger.frames.rbegin() + 1, finger.frames.rend());
  before.push_back(hand.root);
  for (const int f : before) {
    const Vec3 bone = perpendicular_part(axis.point - robot.pose(f).translation(), axis.direction);
    if (bone.norm() > kShortest_m) return bone;
  }
  throw InputError(fmt::format(
      "{}: neither shapes nor a tip tell where {} ends: give meshes with --package NAME=DIR, or a "
      "fixed link at its tip",
      robot.model->file.string(), robot.link[finger.body]));
}

/// Finds the pad of a finger that slides towards the others.
Pad find_sliding_pad(const Kinematics& robot, const Hand& hand, const Finger& finger,
                     const BodyPoints& points) {
  Pad pad;
  pad.frame = finger.body;
  const BodyPoint own = body_middle(robot, finger, points);
  const Vec3 middle = own.at(robot.base_from_frame);
  Vec3 others = Vec3::Zero();
  for (const Finger& other : hand.fingers)
    if (other.body != finger.body)
      others += body_middle(robot, other, points).at(robot.base_from_frame) /
                static_cast<double>(hand.fingers.size() - 1);
  Vec3 normal = robot.axis(pad.frame).direction;
  const double towards_m = (others - middle).dot(normal);
  normal *=
      std::abs(towards_m) > 1e-3 ? std::copysign(1, towards_m) : robot.closing_sign(pad.frame);
  const Vec3 from = robot.pose(hand.root).translation();
  Vec3 bone = perpendicular_part(middle - from, normal);
  if (bone.norm() < 1e-3) bone = perpendicular_part(robot.pose(hand.root).linear().col(2), normal);
  bone.normalize();
  const std::vector<Vec3> body = body_points(robot, pad.frame, points, robot.base_from_frame);
  const Vec3 surface =
      body.empty() ? middle : pad_surface(body, from, bone, normal, end_along(body, from, bone));
  pad.sure = own.sure;
  pad.frame_from_pad = robot.pose(pad.frame).inverse() * make_frame(surface, normal, bone);
  return pad;
}

Pad find_pad(const Kinematics& robot, const Hand& hand, const Finger& finger,
             const BodyPoints& points) {
  if (robot.frame(finger.body).prismatic) return find_sliding_pad(robot, hand, finger, points);
  Pad pad;
  pad.frame = finger.body;
  const Line axis = robot.axis(pad.frame);
  const std::vector<Vec3> body = body_points(robot, pad.frame, points, robot.base_from_frame);
  const int tip_frame = find_urdf_tip(robot, pad.frame, points);
  Vec3 end = Vec3::Zero();
  if (tip_frame >= 0) {
    pad.urdf_tip_link = robot.link[tip_frame];
    end = robot.pose(tip_frame).translation();
    pad.urdf_tip = robot.pose(pad.frame).inverse() * end;
  }
  if (!body.empty()) {
    const Vec3 towards = tip_frame >= 0 ? end : mean_of(body);
    const Vec3 direction =
        perpendicular_part(towards - project_onto_line(axis, towards), axis.direction).normalized();
    const Vec3 shapes_end = farthest_point_along(body, direction);
    pad.tip_beyond_shapes =
        tip_frame >= 0 && (end - shapes_end).dot(direction) > kMaxTipBeyondShapes_m;
    if (!pad.tip_beyond_shapes) end = shapes_end;
  } else if (tip_frame < 0) {
    end = fingertip_from_inertia(robot, pad.frame, axis);
  }
  const Vec3 from = project_onto_line(axis, end);
  Vec3 bone = end - from;
  if (bone.norm() < 1e-4) bone = bone_before(robot, hand, finger, axis);
  bone.normalize();
  const Vec3 normal = robot.closing_sign(pad.frame) * axis.direction.cross(bone);
  const bool measured = !body.empty() && !pad.tip_beyond_shapes;
  const Vec3 surface = measured ? pad_surface(body, from, bone, normal, end_along(body, from, bone))
                                : Vec3(end + kPadDepth_m * normal);
  pad.sure = measured         ? Provenance::derived
             : tip_frame >= 0 ? Provenance::read
                              : Provenance::assumed;
  pad.frame_from_pad = robot.pose(pad.frame).inverse() * make_frame(surface, normal, bone);
  return pad;
}

}  // namespace

std::vector<Pad> find_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points) {
  if (hand.gripper) return gripper_pads(robot, hand, points);
  std::vector<Pad> pads;
  for (const Finger& finger : hand.fingers) pads.push_back(find_pad(robot, hand, finger, points));
  return pads;
}

Palm find_palm(const Kinematics& robot, const Hand& hand, const std::vector<Pad>& pads) {
  const auto pad = [&](int i) { return robot.pose(pads[i].frame) * pads[i].frame_from_pad; };
  const auto knuckle = [&](std::ptrdiff_t i) -> Vec3 {
    const std::vector<int>& frames = hand.fingers[i].frames;  // empty for a fixed jaw
    return robot.pose((frames.empty() ? hand.fingers[0].frames : frames).front()).translation();
  };
  const auto count = std::ssize(hand.fingers);
  Vec3 bones = Vec3::Zero(), normals = Vec3::Zero(), axes = Vec3::Zero(), knuckles = Vec3::Zero();
  double length_m = 0;
  for (int i = 1; i < count; ++i) {
    const double share = 1.0 / static_cast<double>(count - 1);
    const Vec3 bone = pad(i).translation() - knuckle(i);
    bones += share * bone;
    normals += share * pad(i).linear().col(0);
    axes += share * pad(i).linear().col(1);
    knuckles += share * knuckle(i);
    length_m += share * bone.norm();
  }
  if (hand.gripper) knuckles = 0.5 * (knuckle(0) + knuckle(1));
  Palm palm;
  const Vec3 to_thumb = 0.5 * (knuckle(0) + pad(0).translation()) - knuckles;
  // The pads of jaws face each other; a jaw that swings is turned at rest, a fixed one is not.
  const auto of_jaws = [&](int column, double thumb) -> Vec3 {
    const Vec3 fixed = pad(1).linear().col(column);
    return hand.has_fixed_jaw() ? fixed : Vec3(fixed + thumb * pad(0).linear().col(column));
  };
  Vec3 y = hand.gripper ? of_jaws(0, -1) : axes;
  y.normalize();
  const Vec3 order = count > 2 ? Vec3(knuckle(1) - knuckle(count - 1)) : to_thumb;
  // The order of the fingers indicates the side of the thumb even if the thumb is in the middle.
  const Vec3 sidewards = std::abs(order.dot(y)) > 0.005 ? order : to_thumb;
  if (!hand.gripper && sidewards.dot(y) < 0) y = -y;
  const Vec3 z = perpendicular_part(hand.gripper ? of_jaws(2, 1) : bones, y).normalized();
  const Vec3 x = y.cross(z);
  if (!hand.gripper && x.dot(normals) < 0) palm.side = Side::left;
  const double size = hand.gripper ? 1 : length_m / kHumanFingerLength_m;
  const Vec3 wrist = knuckles - size * robot::kFingerProportions[1].along * kHumanHandLength_m * z;
  // For a left hand, y points away from the thumb, so that x points out of the palm.
  const Vec3 out = palm.side == Side::left ? Vec3(-x) : x;
  palm.root_from_palm = robot.pose(hand.root).inverse() * make_frame(wrist, out, z);
  return palm;
}

}  // namespace morphe::setup
