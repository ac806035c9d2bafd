#include "pipeline/setup/centres.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::setup {
namespace {

constexpr double kMeet_m = 0.01;

std::vector<Line> first_lines(const Kinematics& robot, const std::vector<int>& arm,
                              std::size_t count) {
  std::vector<Line> lines;
  for (std::size_t k = 0; k < count; ++k) lines.push_back(robot.axis(arm[k]));
  return lines;
}

double largest_miss(const std::vector<Line>& lines, const Vec3& point) {
  double miss = 0;
  for (const Line& line : lines) miss = std::max(miss, distance(line, point));
  return miss;
}

bool parallel(const Line& a, const Line& b) { return a.direction.cross(b.direction).norm() < 0.1; }

JointCentre at(const Kinematics& robot, int frame, const Vec3& point, Sure sure, double miss_m) {
  return {frame, robot.pose(frame).inverse() * point, sure, miss_m};
}

}  // namespace

ArmCentres arm_centres(const Kinematics& robot, const std::vector<int>& arm) {
  ArmCentres centres;
  if (arm.size() < 3) {
    centres.shoulder =
        at(robot, arm.front(), robot.pose(arm.front()).translation(), Sure::assumed, 0);
    centres.elbow = centres.wrist =
        at(robot, arm.back(), robot.pose(arm.back()).translation(), Sure::assumed, 0);
    return centres;
  }
  std::size_t meeting = 2;
  if (arm.size() > 6) {
    const std::vector<Line> three = first_lines(robot, arm, 3);
    if (largest_miss(three, nearest_point(three)) <= kMeet_m) meeting = 3;
  }
  const std::vector<Line> first = first_lines(robot, arm, meeting);
  const bool meets = !parallel(first[0], first[1]);
  const Vec3 nearest = meets ? nearest_point(first) : first[1].point;
  const double miss = largest_miss(first, nearest);
  const Vec3 shoulder = foot(first[0], nearest);
  centres.shoulder =
      at(robot, arm[0], shoulder, miss <= kMeet_m ? Sure::derived : Sure::assumed, miss);

  const int elbow = arm[meeting];
  centres.elbow = at(robot, elbow, foot(robot.axis(elbow), shoulder), Sure::derived, 0);

  const std::size_t n = arm.size();
  Sure sure = Sure::assumed;
  int frame = arm[n - 2];
  Vec3 wrist = robot.pose(frame).translation();
  double missed = 0;
  for (const auto& [one, other] : {std::pair{n - 3, n - 2}, std::pair{n - 2, n - 1}}) {
    if (one <= meeting) continue;  // that pair has the elbow
    const Line a = robot.axis(arm[one]), b = robot.axis(arm[other]);
    if (parallel(a, b)) continue;
    const Vec3 point = nearest_point({a, b});
    missed = largest_miss({a, b}, point);
    if (missed > kMeet_m) continue;
    sure = Sure::derived;
    frame = arm[one];
    wrist = point;
    break;
  }
  centres.wrist = at(robot, frame, wrist, sure, missed);
  return centres;
}

int middle_joint(const Kinematics& robot, const Finger& finger) {
  constexpr double kAlike = 0.9;  // cos 25 degrees
  const Vec3 last = robot.axis(finger.frames.back()).direction;
  std::vector<int> hinges;
  for (const int f : finger.frames) {
    if (robot.frame(f).slides) continue;
    if (std::abs(robot.axis(f).direction.dot(last)) < kAlike) continue;
    const Vec3 here = robot.pose(f).translation();
    if (!hinges.empty() && (robot.pose(hinges.back()).translation() - here).norm() < 1e-4)
      hinges.pop_back();
    hinges.push_back(f);
  }
  if (hinges.size() < 2) return -1;
  return hinges.size() > 2 ? hinges[hinges.size() - 2] : hinges.back();
}

}  // namespace morphe::setup
