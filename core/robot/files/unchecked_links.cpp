#include <algorithm>
#include <map>
#include <set>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

constexpr double kExtent_m = 0.01;  ///< bodies of a smaller extent need no shape

/// Returns for each frame the rigid body to which it belongs: the nearest frame with a joint,
/// itself included, -1 = base.
std::vector<int> moving_frames(const RobotModel& table) {
  std::vector<int> body;
  for (std::size_t f = 0; f < table.frames.size(); ++f) {
    const int parent = table.frames[f].parent;
    body.push_back(table.frames[f].joint >= 0 ? static_cast<int>(f)
                   : parent < 0               ? -1
                                              : body[parent]);
  }
  return body;
}

/// Returns the distance from each body's own joint to the next joints and to tips.
std::map<int, double> extents(const RobotModel& table, const std::vector<int>& body) {
  std::vector<Pose> body_from_frame;
  std::map<int, double> extent;
  for (std::size_t f = 0; f < table.frames.size(); ++f) {
    const RobotModel::Frame& frame = table.frames[f];
    const auto parent = static_cast<std::size_t>(frame.parent);
    const Pose carried =
        (frame.parent < 0 ? Pose::Identity() : body_from_frame[parent]) * frame.transform;
    const bool moves = frame.joint >= 0;
    body_from_frame.push_back(moves ? Pose::Identity() : carried);
    if (!moves) continue;
    double& reach = extent[frame.parent < 0 ? -1 : body[parent]];
    reach = std::max(reach, carried.translation().norm());
  }
  for (const RobotModel::Tip& tip : table.tips) {
    const auto f = static_cast<std::size_t>(tip.frame);
    double& reach = extent[body[f]];
    reach = std::max(reach, (body_from_frame[f] * tip.transform.translation()).norm());
  }
  return extent;
}

}  // namespace

std::vector<std::string> unchecked_links(const Assembly& assembly) {
  const RobotModel& table = assembly.table;
  const std::vector<int> body = moving_frames(table);
  const auto body_of = [&](int frame) { return frame < 0 ? -1 : body[frame]; };
  std::set<int> covered_bodies, covered_frames;
  for (const RobotModel::Capsule& capsule : table.capsules) {
    covered_bodies.insert(body_of(capsule.frame));
    covered_frames.insert(capsule.frame);
  }
  std::set<int> unchecked;
  for (const auto& [of, reach] : extents(table, body)) {
    if (reach > kExtent_m && !covered_bodies.contains(of)) unchecked.insert(of);
  }
  for (const int frame : assembly.frames_with_geometry) {
    if (!covered_frames.contains(frame)) unchecked.insert(frame);
  }
  std::map<int, std::string> names{{-1, "base"}};
  for (std::size_t f = 0; f < table.frames.size(); ++f) {
    names[static_cast<int>(f)] = table.frames[f].name;
  }
  for (const auto& [link, frame] : assembly.links) names[frame] = link;
  std::vector<std::string> found;
  for (const int frame : unchecked) found.push_back(names[frame]);
  return found;
}

}  // namespace morphe::robot
