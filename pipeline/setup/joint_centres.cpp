#include "pipeline/setup/joint_centres.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::setup {
namespace {

constexpr double kMinNearer_m = 0.001;  ///< by which a later pair of axes must be nearer

/// Returns true if the first of two axes beyond an elbow passes this elbow, unlike the second.
bool twists_forearm(const Line& elbow, const Line& first, const Line& second) {
  return distance(elbow, first) < 0.5 * distance(elbow, second);
}

std::vector<Line> axes_of(const Kinematics& robot, const std::vector<int>& frames) {
  std::vector<Line> lines;
  for (const int frame : frames) lines.push_back(robot.axis(frame));
  return lines;
}

double max_axis_distance(const std::vector<Line>& lines, const Vec3& point) {
  double max_m = 0;
  for (const Line& line : lines) max_m = std::max(max_m, distance(line, point));
  return max_m;
}

JointCentre joint_centre_at(const Kinematics& robot, int frame, const Vec3& point, Provenance sure,
                            double distance_m) {
  return {frame, robot.pose(frame).inverse() * point, sure, distance_m, {}};
}

/// Returns a point near all axes, and on that of the frame `on`.
JointCentre centre_on(const Kinematics& robot, const std::vector<int>& frames, int on) {
  const std::vector<Line> lines = axes_of(robot, frames);
  const Vec3 nearest = point_nearest_to_lines(lines);
  return joint_centre_at(robot, on, project_onto_line(robot.axis(on), nearest), Provenance::derived,
                         max_axis_distance(lines, nearest));
}

/// Returns the axes of a shoulder that may define it, in order of preference.
std::vector<std::vector<int>> defining_axes(const std::vector<int>& f) {
  if (f.size() < 3) return {f};
  return {f, {f[1], f[2]}, {f[0], f[1]}};
}

void add_offsets(const Kinematics& robot, const std::vector<int>& frames, JointCentre& centre) {
  const Vec3 point = position_in_base(robot, centre);
  for (const int frame : frames) {
    const double distance_m = distance(robot.axis(frame), point);
    if (distance_m > kMaxAxisDistance_m) centre.offset_axes.push_back({frame, distance_m});
  }
}

JointCentre best_shoulder(const Kinematics& robot, const std::vector<int>& frames) {
  for (const std::vector<int>& defining : defining_axes(frames)) {
    if (are_parallel(robot.axis(defining[0]), robot.axis(defining[1]))) continue;
    const JointCentre centre = centre_on(robot, defining, defining.front());
    if (centre.axis_distance_m <= kMaxAxisDistance_m) return centre;
  }
  const auto n = frames.size();
  const int swing = frames[n == 2 ? 1 : n - 2];
  JointCentre centre = centre_on(robot, {frames[n - 2], frames[n - 1]}, swing);
  centre.axis_distance_m = 0;  // it is on the axis that swings the upper arm
  return centre;
}

}  // namespace

Vec3 position_in_base(const Kinematics& robot, const JointCentre& centre) {
  return robot.pose(centre.frame) * centre.position;
}

JointCentre shoulder_centre(const Kinematics& robot, const std::vector<int>& frames) {
  if (frames.size() == 1)
    return joint_centre_at(robot, frames[0], robot.pose(frames[0]).translation(),
                           Provenance::assumed, 0);
  JointCentre centre = best_shoulder(robot, frames);
  add_offsets(robot, frames, centre);
  return centre;
}

JointCentre elbow_centre(const Kinematics& robot, int frame, const Vec3& shoulder) {
  return joint_centre_at(robot, frame, project_onto_line(robot.axis(frame), shoulder),
                         Provenance::derived, 0);
}

JointCentre wrist_centre(const Kinematics& robot, int elbow, const std::vector<int>& beyond,
                         const std::optional<Vec3>& end) {
  std::vector<int> turning;
  for (const int frame : beyond)
    if (!robot.frame(frame).prismatic) turning.push_back(frame);
  std::optional<JointCentre> best;
  for (int k = 0; k + 1 < std::ssize(turning); ++k) {
    const std::vector<Line> pair = axes_of(robot, {turning[k], turning[k + 1]});
    if (are_parallel(pair[0], pair[1])) continue;
    const Vec3 point = point_nearest_to_lines(pair);
    const double miss_m = max_axis_distance(pair, point);
    if (best && miss_m > best->axis_distance_m - kMinNearer_m) continue;
    const bool meets = miss_m <= kMaxAxisDistance_m;
    const Line& bend = pair[twists_forearm(robot.axis(elbow), pair[0], pair[1]) ? 1 : 0];
    best = joint_centre_at(robot, turning[k], meets ? point : project_onto_line(bend, point),
                           meets ? Provenance::derived : Provenance::assumed, miss_m);
    if (meets) break;
  }
  if (!best && !turning.empty() && are_parallel(robot.axis(turning[0]), robot.axis(elbow))) {
    const Vec3 point = project_onto_line(robot.axis(turning[0]), robot.pose(elbow).translation());
    best = joint_centre_at(robot, turning[0], point, Provenance::derived, 0);
  }
  if (!best) {
    const int last = beyond.empty() ? elbow : beyond.back();
    const Vec3 point = end.value_or(robot.pose(last).translation());
    best = joint_centre_at(
        robot, last, turning.empty() ? point : project_onto_line(robot.axis(turning[0]), point),
        Provenance::assumed, 0);
  }
  add_offsets(robot, turning, *best);
  return *best;
}

int middle_joint(const Kinematics& robot, const Finger& finger) {
  constexpr double kMinAxisCosine = 0.9;  // cos 25 degrees
  if (finger.frames.empty()) return -1;   // a fixed jaw
  const Vec3 last = robot.axis(finger.frames.back()).direction;
  std::vector<int> hinges;
  for (const int f : finger.frames) {
    if (robot.frame(f).prismatic) continue;
    if (std::abs(robot.axis(f).direction.dot(last)) < kMinAxisCosine) continue;
    const Vec3 origin = robot.pose(f).translation();
    if (!hinges.empty() && (robot.pose(hinges.back()).translation() - origin).norm() < 1e-4)
      hinges.pop_back();
    hinges.push_back(f);
  }
  if (hinges.size() < 2) return -1;
  return hinges.size() > 2 ? hinges[hinges.size() - 2] : hinges.back();
}

}  // namespace morphe::setup
