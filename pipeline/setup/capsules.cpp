#include "pipeline/setup/capsules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

#include "core/cover/fit_capsules.hpp"
#include "core/math/rotation.hpp"
#include "core/parallel/for_each.hpp"
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

/// Returns true if a joint moves the frame or one of its descendants.
bool leads_to_a_joint(const Kinematics& robot, int frame) {
  return robot.moves(frame) || std::ranges::any_of(robot.children[frame], [&](int child) {
           return leads_to_a_joint(robot, child);
         });
}

/// Returns the ends of a link, in its frame and not near its origin: the origins of its children,
/// and a point kPadDepth_m below the surface of its pad. A child without joints is a mark, like the
/// point between a gripper's fingers, if others lead to joints.
std::vector<Vec3> child_origins(const Kinematics& robot, int frame, const std::vector<Pad>& pads) {
  std::vector<Vec3> ends;
  const auto& children = robot.children[frame];
  const auto leads = [&](int child) { return leads_to_a_joint(robot, child); };
  const bool carries_joints = std::ranges::any_of(children, leads);
  for (const int child : children)
    if (!carries_joints || leads(child)) ends.push_back(robot.frame(child).transform.translation());
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

cover::FitOptions fit_options(const Kinematics& robot, int frame, const std::vector<int>& arm,
                              const Hand* hand, const CapsuleBudget& budget) {
  const RobotModel& table = robot.table();
  if (hand && robot::moving_frame_of(table, frame) == robot::moving_frame_of(table, hand->root))
    return {budget.palm, kPalmStandoff_m};
  if (hand && robot::is_in_subtree(table, frame, hand->root))
    return {hand->gripper ? budget.jaw : budget.finger};
  const auto place = std::ranges::find(arm, frame) - arm.begin();
  const bool outer = place < std::ssize(arm) && 2 * place >= std::ssize(arm);
  return {outer ? budget.wrist : budget.arm};
}

/// Fits capsules to the shapes of every frame that has some, on several threads.
std::map<int, cover::CapsuleFit> fit_shapes(const LinkShapes& shapes, int jobs,
                                            const std::function<void(const std::string&)>& progress,
                                            const std::function<cover::CapsuleFit(int)>& fit) {
  std::vector<int> frames;
  for (const auto& [frame, bodies] : shapes.shapes_by_frame) frames.push_back(frame);
  std::map<int, cover::CapsuleFit> fits;
  const auto tell = [&] {
    if (progress) progress(fmt::format("{} of {} links covered", fits.size(), frames.size()));
  };
  tell();
  parallel::ordered_for_each<cover::CapsuleFit>(
      static_cast<int>(frames.size()), jobs,
      [&](std::uint64_t index) { return fit(frames[index]); },
      [&](const cover::CapsuleFit& found) {
        fits.emplace(frames[fits.size()], found);
        tell();
      });
  return fits;
}

}  // namespace

std::vector<RobotModel::Capsule> capsules_of(const cover::CapsuleFit& fit) {
  std::vector<RobotModel::Capsule> capsules;
  for (const collision::CapsuleBody& body : fit.capsules) {
    RobotModel::Capsule& capsule = capsules.emplace_back();
    capsule.from = body.from;
    capsule.to = body.to;
    capsule.radius = body.radius;
  }
  return capsules;
}

std::vector<LinkCapsules> cover_links(const Kinematics& robot, const std::vector<int>& arm,
                                      const Hand* hand, const std::vector<Pad>& pads,
                                      const LinkShapes& shapes, const CapsuleBudget& budget,
                                      int jobs,
                                      const std::function<void(const std::string&)>& progress) {
  const std::map<int, cover::CapsuleFit> fits = fit_shapes(shapes, jobs, progress, [&](int frame) {
    return cover::fit_capsules(shapes.shapes_by_frame.at(frame),
                               fit_options(robot, frame, arm, hand, budget), robot.link[frame]);
  });
  std::vector<LinkCapsules> links;
  std::set<int> shaped;  // moving frames of bodies with shapes
  for (const auto& [frame, objects] : shapes.shapes_by_frame)
    shaped.insert(robot::moving_frame_of(robot.table(), frame));
  for (int frame = 0; frame < std::ssize(robot.table().frames); ++frame) {
    if (shapes.shapes_by_frame.contains(frame)) {
      LinkCapsules& link = links.emplace_back();
      link.frame = frame;
      const cover::CapsuleFit& cover = fits.at(frame);
      link.aim_m = fit_options(robot, frame, arm, hand, budget).aim_m;
      link.capsules = capsules_of(cover);
      link.figures = cover.quality;
      for (const Pad& pad : pads) {
        if (pad.frame != frame || !pad.tip_beyond_shapes) continue;
        link.capsules.push_back(fingertip_capsule(pad));
        ++link.tip_capsules;
      }
    } else if (!shaped.contains(robot::moving_frame_of(robot.table(), frame))) {
      const std::vector<Vec3> ends = child_origins(robot, frame, pads);
      if (!ends.empty()) links.push_back(assumed_capsules(robot, frame, ends));
    }
  }
  return links;
}

}  // namespace morphe::setup
