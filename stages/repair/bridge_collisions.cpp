#include "stages/repair/bridge_collisions.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/robot/tree.hpp"

namespace morphe::repair {
namespace {

/// An interval of samples, both included, that a bridge replaces.
struct BridgedSamples {
  std::ptrdiff_t first, last;
};

/// Returns the first moving frame on the way from the palm to a body's frame; -1 if there is none.
int finger_root(const RobotModel& robot, int frame) {
  const int palm = robot::common_ancestor(robot, frame, robot.palm_frame);
  int root = -1;
  for (const int ancestor : robot::ancestors(robot, frame)) {
    if (ancestor == palm) break;
    if (robot::joint_of(robot, ancestor) >= 0) root = ancestor;
  }
  return root;
}

/// Marks the joints of the finger to which a capsule belongs.
void mark_finger(const RobotModel& robot, const std::string& capsule, std::vector<bool>& joints) {
  const auto body = std::ranges::find(robot.capsules, capsule, &RobotModel::Capsule::name);
  if (body == robot.capsules.end()) return;
  const int root = finger_root(robot, body->frame);
  if (root < 0) return;
  for (int frame = root; frame < std::ssize(robot.frames); ++frame) {
    const int joint = robot::joint_of(robot, frame);
    if (joint >= 0 && robot::is_in_subtree(robot, frame, root)) joints[joint] = true;
  }
}

/// Returns the samples from `margin_s` before a finding to `margin_s` after it.
BridgedSamples samples_of(const Finding& finding, const std::vector<double>& time,
                          double margin_s) {
  const auto first = std::ranges::lower_bound(time, finding.begin_s - margin_s);
  const auto end = std::ranges::upper_bound(time, finding.end_s + margin_s);
  return {first - time.begin(), end - time.begin() - 1};
}

/// Returns the samples that are bridged, joint by joint, in order of time.
std::vector<std::vector<BridgedSamples>> bridges_of(const RobotModel& robot,
                                                    const CheckedPath& checked, double margin_s) {
  std::vector<std::vector<BridgedSamples>> bridges(robot.joint_names.size());
  for (const Finding& finding : checked.findings) {
    if (!is_collision(finding.cause)) continue;
    std::vector<bool> joints(bridges.size());
    mark_finger(robot, finding.subject, joints);
    mark_finger(robot, finding.other_body, joints);
    const BridgedSamples samples = samples_of(finding, checked.path.demonstration_time, margin_s);
    for (std::size_t joint = 0; joint < joints.size(); ++joint) {
      if (joints[joint]) bridges[joint].push_back(samples);
    }
  }
  for (std::vector<BridgedSamples>& list : bridges) {
    std::ranges::sort(list, {}, &BridgedSamples::first);
    std::vector<BridgedSamples> joined;
    for (const BridgedSamples& bridge : list) {
      if (joined.empty() || bridge.first > joined.back().last + 1) joined.push_back(bridge);
      joined.back().last = std::max(joined.back().last, bridge.last);
    }
    list = std::move(joined);
  }
  return bridges;
}

/// Lays a joint's bridge between the samples beside it.
void lay_bridge(const BridgedSamples& bridge, Eigen::Index joint, JointPath& path) {
  const std::ptrdiff_t before = bridge.first - 1, after = bridge.last + 1,
                       count = std::ssize(path.demonstration_time);
  if (before < 0 && after == count) return;
  const std::vector<double>& time = path.demonstration_time;
  const double from = path.position(before < 0 ? after : before, joint),
               to = path.position(after == count ? before : after, joint);
  for (std::ptrdiff_t k = bridge.first; k <= bridge.last; ++k) {
    const double share =
        before < 0 || after == count ? 0 : (time[k] - time[before]) / (time[after] - time[before]);
    path.position(k, joint) = from + share * (to - from);
    path.origin[k] = SampleOrigin::re_solved;
  }
}

}  // namespace

JointPath bridge_collisions(const RobotModel& robot, const CheckedPath& checked, double margin_s) {
  JointPath bridged = checked.path;
  Eigen::Index joint = 0;
  for (const std::vector<BridgedSamples>& bridges : bridges_of(robot, checked, margin_s)) {
    for (const BridgedSamples& bridge : bridges) lay_bridge(bridge, joint, bridged);
    ++joint;
  }
  return bridged;
}

}  // namespace morphe::repair
