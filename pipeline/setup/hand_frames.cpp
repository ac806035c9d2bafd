#include "pipeline/setup/hand_frames.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/hand_proportions.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr double kHumanFingerLength_m = 0.103;  ///< Buchholz 1992, middle finger from its knuckle
constexpr double kHumanHandLength_m = 0.19;

Vec3 perpendicular_part(const Vec3& v, const Vec3& axis) { return v - v.dot(axis) * axis; }

/// Returns the points of a finger's last body and of bodies fixed to it, in the base frame.
std::vector<Vec3> last_link_points(const Kinematics& robot, int last, const BodyPoints& points) {
  std::vector<Vec3> found;
  for (const auto& [frame, own] : points) {
    if (!robot::is_in_subtree(robot.table(), frame, last)) continue;
    if (!joint_frames_between(robot, last, frame).empty()) continue;
    for (const Vec3& point : own) found.push_back(robot.pose(frame) * point);
  }
  return found;
}

/// Returns the farthest frame from the last axis that is named a tip; else that has no shapes; else
/// -1. A metre is added to the distance of frames named a tip, so that they come first.
int find_urdf_tip(const Kinematics& robot, int last, const BodyPoints& points) {
  int best = -1;
  double farthest_m = 1e-3;
  const auto search = [&](const auto& self, int frame) -> void {
    for (const int child : robot.children[frame]) {
      if (robot.moves(child)) continue;
      const bool named = lower_case(robot.link[child]).find("tip") != std::string::npos;
      const double distance_m =
          distance(robot.axis(last), robot.pose(child).translation()) + (named ? 1 : 0);
      if ((named || !points.contains(child)) && distance_m > farthest_m) {
        best = child;
        farthest_m = distance_m;
      }
      self(self, child);
    }
  };
  search(search, last);
  return best;
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point / static_cast<double>(points.size());
  return sum;
}

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

/// Returns the point at the height of the surface along `normal`, slightly before the end along
/// `bone`, and in the middle of the width. `from` is on the bone; the vectors are unit vectors.
Vec3 pad_surface(const std::vector<Vec3>& points, const Vec3& from, const Vec3& bone,
                 const Vec3& normal) {
  double end = -HUGE_VAL, height = -HUGE_VAL;
  for (const Vec3& point : points) end = std::max(end, (point - from).dot(bone));
  const double station = end - std::min(kPadSetback_m, 0.3 * end);
  const Vec3 side = bone.cross(normal);
  double min_side = HUGE_VAL, max_side = -HUGE_VAL;
  for (const Vec3& point : points) {
    if ((point - from).dot(bone) < station - kPadSetback_m) continue;
    height = std::max(height, (point - from).dot(normal));
    min_side = std::min(min_side, (point - from).dot(side));
    max_side = std::max(max_side, (point - from).dot(side));
  }
  return from + station * bone + height * normal + 0.5 * (min_side + max_side) * side;
}

Pose make_frame(const Vec3& origin, const Vec3& x, const Vec3& z) {
  Pose pose = Pose::Identity();
  pose.translation() = origin;
  pose.linear().col(2) = z.normalized();
  pose.linear().col(0) = perpendicular_part(x, pose.linear().col(2)).normalized();
  pose.linear().col(1) = pose.linear().col(2).cross(pose.linear().col(0));
  return pose;
}

/// Returns the point twice as far from the axis as the centre of mass; the joint's without inertia.
Vec3 fingertip_from_inertia(const Kinematics& robot, int last, const Line& axis) {
  const auto inertia = robot.model->inertias.find(robot.link[last]);
  if (inertia == robot.model->inertias.end()) return robot.pose(last).translation();
  const Vec3 centre = robot.pose(last) * inertia->second.link_from_inertia.translation();
  return project_onto_line(axis, centre) +
         2 * perpendicular_part(centre - project_onto_line(axis, centre), axis.direction);
}

Pad find_pad(const Kinematics& robot, const Finger& finger, const BodyPoints& points) {
  Pad pad;
  pad.frame = finger.frames.back();
  const Line axis = robot.axis(pad.frame);
  const std::vector<Vec3> body = last_link_points(robot, pad.frame, points);
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
  if (bone.norm() < 1e-4) bone = axis.direction.unitOrthogonal();
  bone.normalize();
  const Vec3 normal = robot.closing_sign(pad.frame) * axis.direction.cross(bone);
  const bool measured = !body.empty() && !pad.tip_beyond_shapes;
  const Vec3 surface =
      measured ? pad_surface(body, from, bone, normal) : Vec3(end + kPadDepth_m * normal);
  pad.sure = measured         ? Provenance::derived
             : tip_frame >= 0 ? Provenance::read
                              : Provenance::assumed;
  pad.frame_from_pad = robot.pose(pad.frame).inverse() * make_frame(surface, normal, bone);
  return pad;
}

/// Finds both pads together, because the normal of each points to the other.
std::vector<Pad> gripper_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points) {
  std::vector<Vec3> middle;
  for (const Finger& finger : hand.fingers) {
    const std::vector<Vec3> body = last_link_points(robot, finger.frames.back(), points);
    middle.push_back(body.empty() ? robot.pose(finger.frames.back()).translation() : mean_of(body));
  }
  Vec3 between = middle[1] - middle[0];
  if (between.norm() < 1e-3) between = robot.axis(hand.fingers[0].frames.back()).direction;
  between.normalize();
  const Vec3 palm = robot.pose(hand.root).translation();
  Vec3 forward = perpendicular_part(0.5 * (middle[0] + middle[1]) - palm, between);
  if (forward.norm() < 1e-3)
    forward = perpendicular_part(robot.pose(hand.root).linear().col(2), between);
  forward.normalize();
  std::vector<Pad> pads;
  for (const int k : {0, 1}) {
    Pad pad;
    pad.frame = hand.fingers[k].frames.back();
    const Vec3 normal = k == 0 ? between : Vec3(-between);
    const std::vector<Vec3> body = last_link_points(robot, pad.frame, points);
    const int tip_frame = find_urdf_tip(robot, pad.frame, points);
    if (tip_frame >= 0) {
      pad.urdf_tip_link = robot.link[tip_frame];
      pad.urdf_tip = robot.pose(pad.frame).inverse() * robot.pose(tip_frame).translation();
    }
    pad.sure = body.empty() ? Provenance::assumed : Provenance::derived;
    const Vec3 surface = body.empty() ? middle[k] : pad_surface(body, palm, forward, normal);
    pad.frame_from_pad = robot.pose(pad.frame).inverse() * make_frame(surface, normal, forward);
    pads.push_back(pad);
  }
  return pads;
}

}  // namespace

std::vector<Pad> find_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points) {
  if (hand.gripper) return gripper_pads(robot, hand, points);
  std::vector<Pad> pads;
  for (const Finger& finger : hand.fingers) pads.push_back(find_pad(robot, finger, points));
  return pads;
}

Palm find_palm(const Kinematics& robot, const Hand& hand, const std::vector<Pad>& pads) {
  const auto pad = [&](int i) { return robot.pose(pads[i].frame) * pads[i].frame_from_pad; };
  const auto knuckle = [&](std::ptrdiff_t i) -> Vec3 {
    return robot.pose(hand.fingers[i].frames.front()).translation();
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
  Palm palm;
  const Vec3 to_thumb = 0.5 * (knuckle(0) + pad(0).translation()) - knuckles;
  // The pad of a thumb faces the other fingers.
  Vec3 y = hand.gripper ? Vec3(-pad(0).linear().col(0)) : axes;
  y.normalize();
  const Vec3 order = count > 2 ? Vec3(knuckle(1) - knuckle(count - 1)) : to_thumb;
  // The order of the fingers indicates the side of the thumb even if the thumb is in the middle.
  const Vec3 sidewards = std::abs(order.dot(y)) > 0.005 ? order : to_thumb;
  if (!hand.gripper && sidewards.dot(y) < 0) y = -y;
  const Vec3 z =
      (hand.gripper ? Vec3(pad(0).linear().col(2)) : perpendicular_part(bones, y)).normalized();
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
