#include <fmt/format.h>

#include <algorithm>

#include "core/robot/files/assembly.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::robot {
namespace {

constexpr double kParallelSine = 1e-6;

/// Returns the joints whose axis is not along the line to the next position of the chain.
std::vector<int> hinges_of(const RobotModel& table, const std::vector<int>& frames) {
  std::vector<Pose> base_from_frame;
  forward_kinematics(table, JointVector::Zero(table.joints()), base_from_frame);
  const auto pose = [&](int frame) -> const Pose& { return base_from_frame[frame]; };
  std::vector<int> hinges;
  for (auto frame = frames.begin(); frame != frames.end(); ++frame) {
    const RobotModel::Frame& f = table.frames[*frame];
    const Vec3 here = pose(*frame).translation(), axis = pose(*frame).linear() * f.axis;
    const auto next = std::find_if(frame + 1, frames.end(), [&](int other) {
      return (pose(other).translation() - here).norm() > kCoincidentTolerance_m;
    });
    if (f.joint < 0 || f.prismatic || next == frames.end()) continue;
    const Vec3 way = (pose(*next).translation() - here).normalized();
    if (axis.cross(way).norm() > kParallelSine) hinges.push_back(*frame);
  }
  return hinges;
}

}  // namespace

void read_urdf_chain(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node) {
  const config::ConfigNode name = node["name"];
  Chain chain{scope.prefix + name.text(), name.text() == "arm", {}, {}, {}};
  if (has_frame_or_chain(assembly, chain.name)) {
    name.fail(fmt::format("a frame or chain '{}' already exists", chain.name));
  }
  const auto end = [&](const char* key) {
    const std::string joint = scope.prefix + node[key].text();
    int frame = frame_index(assembly.table, joint);  // joints take precedence over links
    if (frame < 0) frame = find_frame(assembly, scope, node[key].text());
    if (frame < 0) node[key].fail(fmt::format("there is no joint or link '{}'", node[key].text()));
    return frame;
  };
  const int first = end("first"), last = end("last");
  if (!is_in_subtree(assembly.table, last, first))
    node["last"].fail("must be a descendant of first");
  for (int frame = last;; frame = assembly.table.frames[frame].parent) {
    chain.frames.push_back(frame);
    if (frame == first) break;
  }
  std::ranges::reverse(chain.frames);
  chain.hinges = hinges_of(assembly.table, chain.frames);
  chain.end = {last};
  assembly.chains.push_back(std::move(chain));
}

}  // namespace morphe::robot
