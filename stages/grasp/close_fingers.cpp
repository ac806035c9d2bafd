#include "stages/grasp/close_fingers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/robot/tree.hpp"

namespace morphe::grasp {
namespace {

/// Returns the capsules that move with the finger of `tip` but not with the palm.
std::vector<int> capsules_of(const robot::Robot& robot, std::size_t tip) {
  std::vector<int> finger_capsules;
  const int palm = robot::moving_frame_of(robot, robot.palm_frame);
  std::vector<int> links;
  for (const int frame : robot::ancestors(robot, robot.tips[tip].frame)) {
    if (robot::moving_frame_of(robot, frame) == palm) break;
    links.push_back(robot::moving_frame_of(robot, frame));
  }
  for (int c = 0; c < std::ssize(robot.capsules); ++c) {
    if (std::ranges::find(links, robot::moving_frame_of(robot, robot.capsules[c].frame)) !=
        links.end())
      finger_capsules.push_back(c);
  }
  return finger_capsules;
}

/// Returns the manners in the order in which they are tried: those that change least come first.
std::vector<ClosingManner> closing_manners() {
  std::vector<ClosingManner> manners;
  for (const int size : {0, 1, 2, 3, 4}) {
    for (const int abduction : {0, 1, -1, 2, -2}) {
      for (const int curl : {0, 1, -1, 2, -2}) {
        if (std::abs(abduction) + std::abs(curl) != size) continue;
        manners.push_back({abduction * kAbductionStep_rad, curl * kCurlStep});
      }
    }
  }
  return manners;
}

/// Closes one finger in the first manner in which it touches with the middle of its pad, or in that
/// in which it touches best. Without a contact, returns nullopt and sets `reason`, that of the
/// first manner.
std::optional<FingerClosure> close_best(FingerProbe& probe, double time_s, std::size_t tip,
                                        const JointVector& q, std::string& reason) {
  std::optional<FingerClosure> best;
  for (const ClosingManner& manner : closing_manners()) {
    std::string failure;
    std::optional<FingerClosure> closing = close_finger(probe, time_s, tip, manner, q, failure);
    if (reason.empty()) reason = failure;
    if (!closing || (best && best->pad_angle_rad <= closing->pad_angle_rad)) continue;
    best = std::move(closing);
    if (best->pad_angle_rad <= kGoodPadAngle_rad) break;
  }
  if (best && best->pad_angle_rad > kMaxContactAngle_rad) {
    reason = fmt::format("it would touch with its side, {:.0f} degrees from the middle of its pad",
                         best->pad_angle_rad / kRadPerDegree);
    best.reset();
  }
  return best;
}

}  // namespace

FingerClosures close_fingers(const collision::CollisionWorld& world, double time_s,
                             const std::vector<std::size_t>& tips, JointVector q) {
  FingerClosures closed;
  if (world.target < 0) return closed;
  const robot::Robot& robot = *world.robot;
  const SceneObject& target = world.scene->objects[world.target];
  for (const std::size_t tip : tips) {
    if (robot.pads[tip].capsule < 0) continue;
    FingerProbe probe{world, capsules_of(robot, tip), {}, recorded_pose(target, time_s), {}};
    for (const std::size_t other : tips) {
      const auto is_other = [&](const FingerClosure& known) { return known.contact.tip == other; };
      if (other == tip || std::ranges::any_of(closed.closings, is_other)) continue;
      const std::vector<int> capsules = capsules_of(robot, other);
      probe.ignored_capsules.insert(probe.ignored_capsules.end(), capsules.begin(), capsules.end());
    }
    std::string reason;
    std::optional<FingerClosure> closing = close_best(probe, time_s, tip, q, reason);
    if (closing) {
      q += closing->turn;
      closed.closings.push_back(std::move(*closing));
    } else {
      closed.open_reasons.push_back(robot.tips[tip].name + " stays open: " + reason);
    }
  }
  return closed;
}

}  // namespace morphe::grasp
