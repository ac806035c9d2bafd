#include "pipeline/setup/capsules.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/cover/cover.hpp"
#include "core/math/rotation.hpp"
#include "core/robot/tree.hpp"

namespace morphe::setup {
namespace {

constexpr double kBone_m = 0.01;  ///< what reaches no farther needs no shape
constexpr double kSameEnd_m = 0.001;

/// As thick as a rod of the link's inertia: I about its long axis = m r² / 2, which is the least of
/// the three.
double thickness(const robot::UrdfInertia& inertia) {
  const Vec3 moments = math::principal_axes(inertia.inertia).moments;
  if (!(inertia.mass > 0) || !(moments[0] > 0)) return 0;
  return std::sqrt(2 * moments[0] / inertia.mass);
}

/// What hangs on a frame, and where its finger ends; the pad's depth below the surface.
std::vector<Vec3> ends_of(const Kinematics& robot, int frame, const std::vector<Pad>& pads) {
  std::vector<Vec3> ends;
  for (const int child : robot.children[static_cast<std::size_t>(frame)]) {
    ends.push_back(robot.frame(child).transform.translation());
  }
  for (const Pad& pad : pads) {
    if (pad.frame == frame) ends.emplace_back(pad.frame_from_pad * Vec3(-kPadDepth_m, 0, 0));
  }
  std::vector<Vec3> apart;
  for (const Vec3& end : ends) {
    const auto same = [&](const Vec3& other) { return (other - end).norm() < kSameEnd_m; };
    if (end.norm() > kBone_m && std::ranges::none_of(apart, same)) apart.push_back(end);
  }
  return apart;
}

/// Bones from a link's origin to what hangs on it.
LinkCapsules bones_of(const Kinematics& robot, int frame, const std::vector<Vec3>& ends) {
  LinkCapsules link;
  link.frame = frame;
  link.sure = Sure::assumed;
  const auto inertia = robot.model->inertias.find(robot.link[static_cast<std::size_t>(frame)]);
  for (const Vec3& end : ends) {
    RobotTable::Capsule bone;
    bone.to = end;
    const double known = inertia == robot.model->inertias.end() ? 0 : thickness(inertia->second);
    bone.radius = std::clamp(known, 0.006, std::max(0.006, 0.5 * end.norm()));
    link.capsules.push_back(bone);
  }
  return link;
}

/// To the tip of a finger whose shapes end before it: as thick as its pad is deep.
RobotTable::Capsule last_bone(const Pad& pad) {
  RobotTable::Capsule bone;
  const Vec3 along = pad.frame_from_pad.linear().col(2);
  const Vec3 tip = pad.frame_from_pad * Vec3(-kPadDepth_m, 0, 0);
  bone.from = tip - tip.dot(along) * along * 0.5;
  bone.to = tip - kBeforeEnd_m * along;
  bone.radius = kPadDepth_m;
  return bone;
}

/// The budget of the link that a frame is.
int budget_of(const Kinematics& robot, int frame, const std::vector<int>& arm, const Hand* hand,
              const CapsuleBudget& budget) {
  if (hand && robot::hangs_on(robot.table(), frame, hand->root)) {
    return frame == hand->root ? budget.palm : budget.finger;
  }
  const auto at = std::ranges::find(arm, frame);
  if (at == arm.end()) return hand ? budget.palm : budget.arm;
  return 2 * (at - arm.begin()) >= static_cast<std::ptrdiff_t>(arm.size()) ? budget.wrist
                                                                           : budget.arm;
}

}  // namespace

std::vector<LinkCapsules> cover_links(const Kinematics& robot, const std::vector<int>& arm,
                                      const Hand* hand, const std::vector<Pad>& pads,
                                      const LinkShapes& shapes, const CapsuleBudget& budget) {
  std::vector<LinkCapsules> links;
  std::set<int> shaped;  // bodies
  for (const auto& [frame, objects] : shapes.of_frame) {
    shaped.insert(robot::body_of(robot.table(), frame));
  }
  for (int frame = 0; frame < static_cast<int>(robot.table().frames.size()); ++frame) {
    if (shapes.of_frame.contains(frame)) {
      LinkCapsules link;
      link.frame = frame;
      const cover::Cover cover =
          cover::cover_bodies(shapes.of_frame.at(frame), budget_of(robot, frame, arm, hand, budget),
                              robot.link[static_cast<std::size_t>(frame)]);
      for (const collision::CapsuleBody& body : cover.capsules) {
        RobotTable::Capsule& capsule = link.capsules.emplace_back();
        capsule.from = body.from;
        capsule.to = body.to;
        capsule.radius = body.radius;
      }
      link.figures = cover.figures;
      for (const Pad& pad : pads) {
        if (pad.frame == frame && pad.beyond_shapes) link.capsules.push_back(last_bone(pad));
      }
      links.push_back(std::move(link));
    } else if (!shaped.contains(robot::body_of(robot.table(), frame))) {
      const std::vector<Vec3> ends = ends_of(robot, frame, pads);
      if (!ends.empty()) links.push_back(bones_of(robot, frame, ends));
    }
  }
  return links;
}

}  // namespace morphe::setup
