#include "core/robot/arm_branch.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/spherical_flips.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::robot {
namespace {

using std::numbers::pi;
using testing::ElementsAre;
using testing::IsEmpty;

ArmBranch branch_at(const RobotModel& robot, const JointVector& q) {
  return branch_of_path(robot, q.transpose(), {0.0});
}

/// The branch of a path on straight lines in joint space, 1 s long.
ArmBranch branch_between(const RobotModel& robot, const JointVector& from, const JointVector& to) {
  constexpr int kRows = 101;
  JointRows position(kRows, from.size());
  std::vector<double> time;
  for (int k = 0; k < kRows; ++k) {
    time.push_back(0.01 * k);
    position.row(k) = (from + time.back() * (to - from)).transpose();
  }
  return branch_of_path(robot, position, time);
}

/// The words that two branches do not share, those of the second.
std::vector<std::string> changed_words(const ArmBranch& first, const ArmBranch& second) {
  std::vector<std::string> changed;
  for (const std::string& word : second.words)
    if (std::ranges::find(first.words, word) == first.words.end()) changed.push_back(word);
  return changed;
}

std::string part_of(const std::string& word) { return word.substr(0, word.find(' ')); }

/// Positions away from singularities and from whole turns.
JointVector plain_posture(const RobotModel& robot, std::mt19937& random) {
  JointVector q = zero_position(robot);
  for (const int frame : arm_hinges(robot)) {
    const double size = std::uniform_real_distribution<>(0.4, 1.2)(random);
    q[robot.frames[frame].joint] = random() % 2 == 0 ? size : -size;
  }
  return q;
}

TEST(ArmBranch, AFlipChangesExactlyTheWordOfItsPart) {
  std::mt19937 random(1);
  const std::array<const char*, 3> parts{"shoulder", "elbow", "wrist"};
  for (const char* name : {"pa10", "pa10_dlr_hit2", "iiwa14", "fr3", "panda"}) {
    const RobotModel robot = shipped_robot(name);
    const std::vector<int> hinges = arm_hinges(robot);
    const bool offset_elbow = name == std::string("fr3") || name == std::string("panda");
    int flips = 0;
    for (const SphericalFlip& flip : possible_flips(robot)) {
      for (int part = 0; part < 3; ++part) {
        if (robot.frames[hinges[2 * part]].joint != flip.first || (offset_elbow && part == 1))
          continue;  // the stretched position of an offset elbow is not where the axes are parallel
        ++flips;
        for (int trial = 0; trial < 20; ++trial) {
          const JointVector q = plain_posture(robot, random);
          const ArmBranch before = branch_at(robot, q);
          const ArmBranch after = branch_at(robot, apply_flip(flip, q));
          std::vector<std::string> changed = changed_words(before, after);
          std::erase_if(changed, [](const std::string& w) { return w.ends_with("turn"); });
          ASSERT_EQ(changed.size(), 1u) << name;
          EXPECT_EQ(part_of(changed[0]), parts[part]) << name;
          EXPECT_EQ(*before.number ^ *after.number, 1 << part) << name;
        }
      }
    }
    EXPECT_EQ(flips, offset_elbow ? 2 : 3) << name;
  }
}

/// Denavit–Hartenberg parameters of the UR5e, from Universal Robots' table.
constexpr std::array<double, 6> kD{0.1625, 0, 0, 0.1333, 0.0997, 0.0996};
constexpr std::array<double, 6> kA{0, -0.425, -0.3922, 0, 0, 0};
constexpr std::array<double, 6> kAlpha{pi / 2, 0, 0, pi / 2, -pi / 2, 0};

Pose ur_link(int joint, double angle) {
  Pose pose = Pose::Identity();
  pose.rotate(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  pose.translate(Vec3(kA[joint], 0, kD[joint]));
  pose.rotate(Eigen::AngleAxisd(kAlpha[joint], Vec3::UnitX()));
  return pose;
}

/// A solution with the choices that led to it.
struct UrSolution {
  int shoulder, wrist, elbow;
  JointVector q;
};

/// The eight solutions of a posture's own pose, in closed form.
std::vector<UrSolution> ur_solutions(const JointVector& posture) {
  Pose pose = Pose::Identity();
  for (int k = 0; k < 6; ++k) pose = pose * ur_link(k, posture[k]);
  const Vec3 wrist_point = pose * Vec3(0, 0, -kD[5]), tip = pose.translation();
  const Eigen::Matrix3d back = pose.linear().transpose();
  std::vector<UrSolution> solutions;
  for (const int shoulder : {1, -1}) {
    for (const int wrist : {1, -1}) {
      for (const int elbow : {1, -1}) {
        JointVector q(6);
        q[0] = std::atan2(wrist_point.y(), wrist_point.x()) +
               shoulder * std::acos(kD[3] / std::hypot(wrist_point.x(), wrist_point.y())) + pi / 2;
        const double s1 = std::sin(q[0]), c1 = std::cos(q[0]);
        q[4] = wrist * std::acos((tip.x() * s1 - tip.y() * c1 - kD[3]) / kD[5]);
        const double s5 = std::sin(q[4]);
        q[5] = std::atan2((-back(1, 0) * s1 + back(1, 1) * c1) / s5,
                          (back(0, 0) * s1 - back(0, 1) * c1) / s5);
        const Pose forearm =
            ur_link(0, q[0]).inverse() * pose * (ur_link(4, q[4]) * ur_link(5, q[5])).inverse();
        const Vec3 p = forearm.translation();
        const double reach = std::hypot(p.x(), p.y());
        const double cosine = (reach * reach - kA[1] * kA[1] - kA[2] * kA[2]) / (2 * kA[1] * kA[2]);
        q[2] = elbow * std::acos(cosine);
        q[1] = std::atan2(-p.y(), -p.x()) - std::asin(-kA[2] * std::sin(q[2]) / reach);
        const Pose last = (ur_link(1, q[1]) * ur_link(2, q[2])).inverse() * forearm;
        q[3] = std::atan2(last.linear()(1, 0), last.linear()(0, 0));
        solutions.push_back({shoulder, wrist, elbow, q});
      }
    }
  }
  return solutions;
}

TEST(ArmBranch, EachOfTheEightSolutionsOfAUR5eHasItsOwn) {
  const RobotModel robot = shipped_robot("ur5e");
  const JointVector posture{{0.4, -1.9, 1.7, -1.1, -1.3, 0.6}};
  std::vector<Pose> wanted, reached;
  forward_kinematics(robot, posture, wanted);
  std::set<int> numbers;
  std::set<std::string> shoulders, wrists;
  for (const UrSolution& solution : ur_solutions(posture)) {
    forward_kinematics(robot, solution.q, reached);
    const Pose& goal = wanted[robot.palm_frame];
    ASSERT_TRUE(reached[robot.palm_frame].isApprox(goal, 1e-3));  // it is a solution
    const ArmBranch branch = branch_at(robot, solution.q);
    numbers.insert(*branch.number);
    shoulders.insert(fmt::format("{} {}", solution.shoulder, branch.words[0]));
    wrists.insert(fmt::format("{} {}", solution.wrist, branch.words[2]));
    // The elbow is up in the higher one of two solutions that differ in the elbow alone.
    JointVector other = solution.q;
    for (const UrSolution& one : ur_solutions(posture))
      if (one.shoulder == solution.shoulder && one.wrist == solution.wrist &&
          one.elbow != solution.elbow)
        other = one.q;
    std::vector<Pose> opposite;
    forward_kinematics(robot, other, opposite);
    const std::vector<int> hinges = arm_hinges(robot);
    const ArmAxes axes = arm_axes(robot, hinges, reached);
    const Vec3 higher = reached[hinges[2]].translation() - opposite[hinges[2]].translation();
    EXPECT_EQ(branch.words[1], higher.dot(axes.direction[0]) > 0 ? "elbow up" : "elbow down");
  }
  EXPECT_EQ(numbers.size(), 8u);
  EXPECT_EQ(shoulders.size(), 2u);
  EXPECT_EQ(wrists.size(), 2u);
}

TEST(ArmBranch, AnElbowIsStretchedWhereShoulderAndWristAreFarthestApart) {
  for (const char* name : {"fr3", "xarm7", "wam", "gen3", "ur5e"}) {
    const RobotModel robot = shipped_robot(name);
    const ArmAnatomy anatomy = find_arm_anatomy(robot);
    ASSERT_GE(anatomy.elbow, 0) << name;
    const int joint = robot.frames[anatomy.hinges[anatomy.elbow]].joint;
    JointVector q = zero_position(robot);
    std::vector<Pose> poses;
    double farthest = 0, at = 0;
    for (double angle = -3; angle < 3; angle += 1e-3) {
      q[joint] = angle;
      forward_kinematics(robot, q, poses);
      const ArmAxes axes = arm_axes(robot, anatomy.hinges, poses);
      const int e = anatomy.elbow;
      const Vec3 s = foot_point(axes, e - 1, e - 2, e), w = foot_point(axes, e + 1, e + 2, e);
      const double apart = (s - w).norm();
      if (apart > farthest) at = angle;
      farthest = std::max(farthest, apart);
    }
    q[joint] = at;
    forward_kinematics(robot, q, poses);
    EXPECT_NEAR(branch_factors(robot, anatomy, poses).elbow, 0, 2e-3) << name;
  }
}

TEST(ArmBranch, ChangesAlongThePathAreTold) {
  const RobotModel robot = shipped_robot("iiwa14");
  JointVector from{{0.3, 0.5, 0.2, -1.2, 0.4, -0.6, 0.1}}, to = from;
  EXPECT_THAT(branch_between(robot, from, to).changes, IsEmpty());
  to[5] = 0.2;  // through zero at 0.75 s
  const ArmBranch branch = branch_between(robot, from, to);
  const ArmBranch begin = branch_at(robot, from), end = branch_at(robot, to);
  EXPECT_EQ(branch.number, begin.number);  // that of most of the path
  ASSERT_EQ(changed_words(begin, end).size(), 1u);
  const std::string after = end.words[2].substr(6);
  EXPECT_THAT(branch.changes, ElementsAre(begin.words[2] + " -> " + after + " at 0.82 s"));
}

TEST(ArmBranch, AJointThatIsWoundUpIsTold) {
  const RobotModel robot = shipped_robot("ur5e");
  JointVector q{{0.4, -1.9, 1.7, -1.1, -1.3, 0.6}};
  const ArmBranch plain = branch_at(robot, q);
  q[5] += 2 * pi;
  const ArmBranch wound = branch_at(robot, q);
  EXPECT_EQ(wound.number, plain.number);
  EXPECT_THAT(changed_words(plain, wound),
              ElementsAre(robot.joint_names[5] + " wound up by +1 turn"));
  q[5] = 3.3;  // 2.98 the other way round is not worth a word
  EXPECT_EQ(branch_at(robot, q), plain);
}

TEST(ArmBranch, AStretchedArmIsUndecided) {
  const RobotModel robot = shipped_robot("iiwa14");
  const ArmBranch branch = branch_at(robot, JointVector{{0.3, 0.5, 0.2, 0.01, 0.4, 0.6, 0.1}});
  EXPECT_EQ(branch.words[1], "elbow undecided");
}

/// Hinges along x with these axes at zero; the first two are 0.05 m apart, others 0.3 m.
RobotModel chain_of(const std::vector<Vec3>& axes) {
  RobotModel robot;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    RobotModel::Frame frame;
    frame.name = robot.joint_names.emplace_back("j" + std::to_string(k + 1));
    frame.parent = static_cast<int>(k) - 1;
    frame.joint = static_cast<int>(k);
    frame.axis = axes[k];
    if (k > 0) frame.transform.translation() = Vec3(k == 1 ? 0.05 : 0.3, 0, 0);
    robot.frames.push_back(frame);
  }
  RobotModel::Frame palm;
  palm.name = "palm";
  palm.parent = static_cast<int>(axes.size()) - 1;
  palm.transform.translation() = Vec3(0.3, 0, 0);
  robot.palm_frame = static_cast<int>(robot.frames.size());
  robot.frames.push_back(palm);
  robot.lower = JointVector::Constant(std::ssize(axes), -3);
  robot.upper = -robot.lower;
  return robot;
}

TEST(ArmBranch, AnArmWithFewerPartsHasFewerWords) {
  const Vec3 y = Vec3::UnitY(), z = Vec3::UnitZ(), x = Vec3::UnitX();
  const RobotModel planar = chain_of({z, z, z});
  // The last hinge is between the longest links, and a bend about its axis is positive.
  EXPECT_THAT(branch_at(planar, JointVector{{0.3, -2, 0.5}}).words, ElementsAre("elbow positive"));
  EXPECT_THAT(branch_at(planar, JointVector{{0.3, 2, -0.5}}).words, ElementsAre("elbow negative"));
  const RobotModel five = chain_of({z, y, y, y, x});
  const ArmBranch branch = branch_at(five, JointVector{{0.3, -0.5, 0.8, 0.2, 0.1}});
  ASSERT_EQ(branch.words.size(), 2u);
  EXPECT_EQ(part_of(branch.words[0]), "shoulder");
  EXPECT_EQ(branch.words[1], "elbow up");  // y turns x down: the upper arm rises, the forearm sinks
}

TEST(ArmBranch, AHandAloneHasNone) {
  for (const char* name : {"dlr_hit2", "allegro", "shadow", "robotiq_2f85"}) {
    const RobotModel robot = shipped_robot(name);
    EXPECT_EQ(branch_at(robot, 0.5 * (robot.lower + robot.upper)), ArmBranch()) << name;
  }
}

}  // namespace
}  // namespace morphe::robot
