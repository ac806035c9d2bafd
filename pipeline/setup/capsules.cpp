#include "pipeline/setup/capsules.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/cover/fit_capsules.hpp"
#include "core/math/rotation.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

constexpr double kMinLinkLength_m = 0.01;  ///< shorter links need no shape
constexpr double kEndTolerance_m = 0.001;  ///< ends nearer to each other count as one

/// Returns r from m r² / 2 = the least moment of inertia, as of a rod about its axis; else 0.
double equivalent_rod_radius(const robot::UrdfInertia& inertia) {
  const Vec3 moments = math::principal_axes(inertia.inertia).moments;
  if (!(inertia.mass > 0) || !(moments[0] > 0)) return 0;
  return std::sqrt(2 * moments[0] / inertia.mass);
}

/// Returns the ends of a link, in its frame and not near its origin: the origins of its children,
/// and a point kPadDepth_m below the surface of its pad.
std::vector<Vec3> child_origins(const Kinematics& robot, int frame, const std::vector<Pad>& pads) {
  std::vector<Vec3> ends;
  for (const int child : robot.children[frame])
    ends.push_back(robot.frame(child).transform.translation());
  for (const Pad& pad : pads)
    if (pad.frame == frame) ends.emplace_back(pad.frame_from_pad * Vec3(-kPadDepth_m, 0, 0));
  std::vector<Vec3> distinct;
  for (const Vec3& end : ends) {
    const auto same = [&](const Vec3& other) { return (other - end).norm() < kEndTolerance_m; };
    if (end.norm() > kMinLinkLength_m && std::ranges::none_of(distinct, same))
      distinct.push_back(end);
  }
  return distinct;
}

/// Returns one assumed capsule from the origin of a link to each of its ends.
LinkCapsules assumed_capsules(const Kinematics& robot, int frame, const std::vector<Vec3>& ends) {
  LinkCapsules link;
  link.frame = frame;
  link.sure = Provenance::assumed;
  const auto inertia = robot.model->inertias.find(robot.link[frame]);
  for (const Vec3& end : ends) {
    RobotModel::Capsule bone;
    bone.to = end;
    const double known =
        inertia == robot.model->inertias.end() ? 0 : equivalent_rod_radius(inertia->second);
    bone.radius = std::clamp(known, 0.006, std::max(0.006, 0.5 * end.norm()));
    link.capsules.push_back(bone);
  }
  return link;
}

/// Returns a capsule to the tip of a finger, whose shapes end before this tip.
RobotModel::Capsule fingertip_capsule(const Pad& pad) {
  RobotModel::Capsule bone;
  const Vec3 bone_axis = pad.frame_from_pad.linear().col(2);
  const Vec3 tip = pad.frame_from_pad * Vec3(-kPadDepth_m, 0, 0);
  bone.from = tip - tip.dot(bone_axis) * bone_axis * 0.5;
  bone.to = tip - kPadSetback_m * bone_axis;
  bone.radius = kPadDepth_m;
  return bone;
}

int budget_of(const Kinematics& robot, int frame, const std::vector<int>& arm, const Hand* hand,
              const CapsuleBudget& budget) {
  if (hand && robot::is_in_subtree(robot.table(), frame, hand->root))
    return frame == hand->root ? budget.palm : budget.finger;
  const auto place = std::ranges::find(arm, frame) - arm.begin();
  if (place == std::ssize(arm)) return hand ? budget.palm : budget.arm;
  return 2 * place >= std::ssize(arm) ? budget.wrist : budget.arm;
}

}  // namespace

std::vector<LinkCapsules> cover_links(const Kinematics& robot, const std::vector<int>& arm,
                                      const Hand* hand, const std::vector<Pad>& pads,
                                      const LinkShapes& shapes, const CapsuleBudget& budget) {
  std::vector<LinkCapsules> links;
  std::set<int> shaped;  // moving frames of bodies with shapes
  for (const auto& [frame, objects] : shapes.shapes_by_frame)
    shaped.insert(robot::moving_frame_of(robot.table(), frame));
  for (int frame = 0; frame < std::ssize(robot.table().frames); ++frame) {
    if (shapes.shapes_by_frame.contains(frame)) {
      LinkCapsules& link = links.emplace_back();
      link.frame = frame;
      const cover::CapsuleFit cover =
          cover::fit_capsules(shapes.shapes_by_frame.at(frame),
                              budget_of(robot, frame, arm, hand, budget), robot.link[frame]);
      for (const collision::CapsuleBody& body : cover.capsules) {
        RobotModel::Capsule& capsule = link.capsules.emplace_back();
        capsule.from = body.from;
        capsule.to = body.to;
        capsule.radius = body.radius;
      }
      link.figures = cover.quality;
      for (const Pad& pad : pads)
        if (pad.frame == frame && pad.tip_beyond_shapes)
          link.capsules.push_back(fingertip_capsule(pad));
    } else if (!shaped.contains(robot::moving_frame_of(robot.table(), frame))) {
      const std::vector<Vec3> ends = child_origins(robot, frame, pads);
      if (!ends.empty()) links.push_back(assumed_capsules(robot, frame, ends));
    }
  }
  return links;
}

}  // namespace morphe::setup
