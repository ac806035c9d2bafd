#include "pipeline/setup/joint_centres.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::setup {
namespace {

constexpr double kMaxAxisDistance_m = 0.01;

std::vector<Line> first_lines(const Kinematics& robot, const std::vector<int>& arm, int count) {
  std::vector<Line> lines;
  for (int k = 0; k < count; ++k) lines.push_back(robot.axis(arm[k]));
  return lines;
}

double max_axis_distance(const std::vector<Line>& lines, const Vec3& point) {
  double max_m = 0;
  for (const Line& line : lines) max_m = std::max(max_m, distance(line, point));
  return max_m;
}

bool parallel(const Line& a, const Line& b) { return a.direction.cross(b.direction).norm() < 0.1; }

JointCentre joint_centre_at(const Kinematics& robot, int frame, const Vec3& point, Provenance sure,
                            double distance_m) {
  return {frame, robot.pose(frame).inverse() * point, sure, distance_m};
}

}  // namespace

ArmCentres arm_centres(const Kinematics& robot, const std::vector<int>& arm) {
  ArmCentres centres;
  if (arm.size() < 3) {
    centres.shoulder = joint_centre_at(robot, arm.front(), robot.pose(arm.front()).translation(),
                                       Provenance::assumed, 0);
    centres.elbow = centres.wrist = joint_centre_at(
        robot, arm.back(), robot.pose(arm.back()).translation(), Provenance::assumed, 0);
    return centres;
  }
  int meeting = 2;  // number of first axes that meet in the shoulder
  if (arm.size() > 6) {
    const std::vector<Line> three = first_lines(robot, arm, 3);
    if (max_axis_distance(three, point_nearest_to_lines(three)) <= kMaxAxisDistance_m) meeting = 3;
  }
  const std::vector<Line> first = first_lines(robot, arm, meeting);
  const bool meets = !parallel(first[0], first[1]);
  const Vec3 nearest = meets ? point_nearest_to_lines(first) : first[1].point;
  const double miss_m = max_axis_distance(first, nearest);
  const Vec3 shoulder = project_onto_line(first[0], nearest);
  centres.shoulder = joint_centre_at(
      robot, arm[0], shoulder,
      miss_m <= kMaxAxisDistance_m ? Provenance::derived : Provenance::assumed, miss_m);

  const int elbow = arm[meeting];
  centres.elbow = joint_centre_at(robot, elbow, project_onto_line(robot.axis(elbow), shoulder),
                                  Provenance::derived, 0);

  const auto n = std::ssize(arm);
  Provenance sure = Provenance::assumed;
  int frame = arm[n - 2];
  Vec3 wrist = robot.pose(frame).translation();
  double wrist_miss_m = 0;
  for (const auto& [one, other] : {std::pair{n - 3, n - 2}, std::pair{n - 2, n - 1}}) {
    if (one <= meeting) continue;  // that pair includes the elbow
    const Line a = robot.axis(arm[one]), b = robot.axis(arm[other]);
    if (parallel(a, b)) continue;
    const Vec3 point = point_nearest_to_lines({a, b});
    wrist_miss_m = max_axis_distance({a, b}, point);
    if (wrist_miss_m > kMaxAxisDistance_m) continue;
    sure = Provenance::derived;
    frame = arm[one];
    wrist = point;
    break;
  }
  centres.wrist = joint_centre_at(robot, frame, wrist, sure, wrist_miss_m);
  return centres;
}

int middle_joint(const Kinematics& robot, const Finger& finger) {
  constexpr double kMinAxisCosine = 0.9;  // cos 25 degrees
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
