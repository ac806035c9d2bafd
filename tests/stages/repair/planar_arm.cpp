#include "tests/stages/repair/planar_arm.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace morphe::test {

RobotModel planar_arm() {
  robot::Robot robot;
  robot.name = "planar";
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i + 1);
    robot.joint_names.push_back("J" + number);
    RobotModel::Frame frame;
    frame.name = "link" + number;
    frame.parent = i - 1;
    if (i > 0) frame.transform.translation() = Vec3(0.4, 0, 0);
    frame.joint = i;
    robot.frames.push_back(frame);
    robot.capsules.push_back({"link" + number, i, Vec3(0.05, 0, 0), Vec3(0.38, 0, 0), 0.03, false});
  }
  robot.lower = JointVector::Constant(3, -2.5);
  robot.upper = JointVector::Constant(3, 2.5);
  robot.velocity = JointVector::Constant(3, 2);
  robot.acceleration = JointVector::Constant(3, 10);
  robot.jerk = JointVector::Constant(3, 100);
  RobotModel::Tip tip;
  tip.name = "tip";
  tip.frame = 2;
  tip.transform.translation() = Vec3(0.4, 0, 0);
  robot.tips.push_back(tip);
  robot.joint_centres.push_back({1, "arm"});
  robot.allowed_collision_pairs = {{0, 1}, {1, 2}};
  robot.palm_frame = 2;
  return robot;
}

SceneObject post(const std::string& name, double x, double y) {
  SceneObject object;
  object.name = name;
  object.shape = Shape::cylinder;
  object.size = {0.04, 0.5};
  object.time = {0};
  object.position = {Vec3(x, y, 0)};
  object.orientation = {Quat::Identity()};
  return object;
}

JointPath sweep(const JointVector& from, const JointVector& to) {
  constexpr int kSamples = 101;
  JointPath path;
  path.position.resize(kSamples, from.size());
  for (int k = 0; k < kSamples; ++k) {
    const double u = k / (kSamples - 1.0);
    const double s = u * u * u * (10 + u * (6 * u - 15));
    path.position.row(k) = from + s * (to - from);
    path.demonstration_time.push_back(0.01 * k);
  }
  path.origin.assign(kSamples, SampleOrigin::mapped);
  return path;
}

Bench::Bench(std::vector<SceneObject> objects, RobotModel of) : robot(std::move(of)) {
  scene.objects = std::move(objects);
  world = collision::make_world(robot, scene, Movement{}, Tolerances{});
}

std::vector<Finding> Bench::collisions(const JointPath& path) const {
  std::vector<Finding> findings;
  collision::CollisionScratch scratch;
  bool open = false;
  for (Eigen::Index k = 0; k + 1 < path.position.rows(); ++k) {
    const auto sample = static_cast<std::size_t>(k);
    const double begin_s = path.demonstration_time[sample];
    const double end_s = path.demonstration_time[sample + 1];
    const collision::MotionCheck edge = collision::check_motion(
        world,
        collision::straight_motion(path.position.row(k), path.position.row(k + 1), begin_s, end_s),
        scratch);
    const bool bad = edge.verdict != collision::MotionVerdict::free;
    if (bad && !open)
      findings.push_back(
          {begin_s, end_s,
           edge.pair.other_is_object ? Cause::object_collision : Cause::self_collision,
           collision::first_body_name(world, edge.pair),
           collision::second_body_name(world, edge.pair), 0});
    if (bad) {
      findings.back().end_s = end_s;
      findings.back().excess = std::max(findings.back().excess, -edge.pair.slack());
    }
    open = bad;
  }
  return findings;
}

double Bench::densely_sampled_slack(const JointPath& path) const {
  collision::CollisionScratch scratch;
  double least = 1e9;
  for (Eigen::Index k = 0; k + 1 < path.position.rows(); ++k) {
    for (int part = 0; part <= 20; ++part) {
      const JointVector q =
          path.position.row(k) + part / 20.0 * (path.position.row(k + 1) - path.position.row(k));
      const double time_s = path.demonstration_time[static_cast<std::size_t>(k)];
      least = std::min(least, collision::least_slack(world, q, time_s, scratch).slack());
    }
  }
  return least;
}

}  // namespace morphe::test
