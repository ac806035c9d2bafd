#include "stages/grasp/close_fingers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

FingerProbe probe_finger(const collision::CollisionWorld& world, double time_s,
                         const FingerInHand& finger) {
  const robot::Robot& robot = *world.robot;
  const SceneObject& target = world.scene->objects[world.target];
  FingerProbe probe{world, capsules_of(robot, finger.tip), {}, recorded_pose(target, time_s), {}};
  std::vector<int> ignored;
  for (const std::size_t other : finger.unclosed)
    std::ranges::copy(capsules_of(robot, other), std::back_inserter(ignored));
  const auto is_in = [](const std::vector<int>& capsules, int capsule) {
    return std::ranges::find(capsules, capsule) != capsules.end();
  };
  for (const std::array<int, 2>& pair : world.pairs) {
    const auto [first, second] = pair;
    if (is_in(probe.finger_capsules, first) == is_in(probe.finger_capsules, second)) continue;
    if (!is_in(ignored, first) && !is_in(ignored, second)) probe.pairs.push_back(pair);
  }
  return probe;
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
  for (const std::size_t tip : tips) {
    if (robot.pads[tip].capsule < 0) continue;
    FingerInHand finger{tip, tips};
    std::erase_if(finger.unclosed, [&](std::size_t other) {
      const auto is_other = [&](const FingerClosure& known) { return known.contact.tip == other; };
      return other == tip || std::ranges::any_of(closed.closings, is_other);
    });
    FingerProbe probe = probe_finger(world, time_s, finger);
    std::string reason;
    std::optional<FingerClosure> closing = close_best(probe, time_s, tip, q, reason);
    if (closing) {
      q += closing->turn;
      closed.closings.push_back(std::move(*closing));
    } else {
      closed.open.push_back({tip, std::move(reason)});
    }
  }
  return closed;
}

std::optional<FingerClosure> close_straight(const collision::CollisionWorld& world, double time_s,
                                            const FingerInHand& finger, const JointVector& q) {
  FingerProbe probe = probe_finger(world, time_s, finger);
  std::string reason;
  return close_finger(probe, time_s, finger.tip, {}, q, reason);
}

bool closes_freely(const collision::CollisionWorld& world, double time_s,
                   const FingerInHand& finger, const JointVector& open, const JointVector& closed) {
  FingerProbe probe = probe_finger(world, time_s, finger);
  const int pad = world.robot->pads[finger.tip].capsule;
  for (int step = 1; step <= kClosingChecks; ++step) {
    probe.pose(open + static_cast<double>(step) / kClosingChecks * (closed - open), time_s);
    for (const int capsule : probe.finger_capsules) {
      const double allowed = capsule == pad ? world.tolerances.max_penetration : 0;
      if (probe.separation_from_target(capsule).distance < -allowed) return false;
    }
    if (!probe.find_obstacle().empty()) return false;
  }
  return true;
}

}  // namespace morphe::grasp
