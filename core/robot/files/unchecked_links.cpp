#include <algorithm>
#include <map>
#include <set>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

constexpr double kMinExtent_m = 0.01;  ///< bodies of a smaller extent need no capsule

/// Returns for each moving frame (-1 = base) the largest distance to joints and tips of its body.
std::map<int, double> extents(const RobotModel& table) {
  std::vector<Pose> body_from_frame;
  std::map<int, double> extent;
  const auto extend = [&](int frame, double distance) {
    double& max_distance = extent[moving_frame_of(table, frame)];
    max_distance = std::max(max_distance, distance);
  };
  for (const RobotModel::Frame& frame : table.frames) {
    const Pose pose =
        (frame.parent < 0 ? Pose::Identity() : body_from_frame[frame.parent]) * frame.transform;
    const bool moves = frame.joint >= 0;
    body_from_frame.push_back(moves ? Pose::Identity() : pose);
    if (moves) extend(frame.parent, pose.translation().norm());
  }
  for (const RobotModel::Tip& tip : table.tips)
    extend(tip.frame, (body_from_frame[tip.frame] * tip.transform.translation()).norm());
  return extent;
}

}  // namespace

std::vector<std::string> unchecked_links(const Assembly& assembly) {
  const RobotModel& table = assembly.table;
  std::set<int> covered_bodies, covered_frames;
  for (const RobotModel::Capsule& capsule : table.capsules) {
    covered_bodies.insert(moving_frame_of(table, capsule.frame));
    covered_frames.insert(capsule.frame);
  }
  std::set<int> unchecked;
  for (const auto& [body, extent_m] : extents(table)) {
    if (extent_m > kMinExtent_m && !covered_bodies.contains(body)) unchecked.insert(body);
  }
  for (const int frame : assembly.frames_with_geometry) {
    if (!covered_frames.contains(frame)) unchecked.insert(frame);
  }
  std::map<int, std::string> names{{-1, "base"}};
  for (int f = 0; f < std::ssize(table.frames); ++f) names[f] = table.frames[f].name;
  for (const auto& [link, frame] : assembly.links) names[frame] = link;
  std::vector<std::string> unchecked_names;
  for (const int frame : unchecked) unchecked_names.push_back(names[frame]);
  return unchecked_names;
}

}  // namespace morphe::robot
