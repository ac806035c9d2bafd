#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>
#include <random>

#include "pipeline/motion/input_error.hpp"
#include "pipeline/robot/forward.hpp"
#include "tests/pipeline/robot/files/generated_products.hpp"
#include "tests/pipeline/robot/files/written_urdf.hpp"

namespace morphe::robot {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Urdf, JointsInTheFilesOrderBehindTheirParents) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotDescription description = load_robot(write_robot("two", kDescription));
  const RobotTable& robot = description.table;
  EXPECT_EQ(description.files.size(), 3u);
  EXPECT_THAT(robot.joint_names, ElementsAre("a", "b"));
  std::vector<std::string> frames;
  for (const auto& frame : robot.frames) frames.push_back(frame.name);
  EXPECT_THAT(frames, ElementsAre("a", "b", "tool", "c", "d"));
  EXPECT_THAT(std::vector(robot.upper.begin(), robot.upper.end()),
              ElementsAre(1, testing::DoubleNear(rad(90), 1e-15)));
  EXPECT_THAT(std::vector(robot.velocity.begin(), robot.velocity.end()), ElementsAre(2, 3));
  EXPECT_THAT(std::vector(robot.acceleration.begin(), robot.acceleration.end()), ElementsAre(5, 5));
  EXPECT_THAT(std::vector(robot.jerk.begin(), robot.jerk.end()), ElementsAre(50, 70));
  EXPECT_EQ(robot.shoulder_frame, 0);
  EXPECT_EQ(robot.palm_frame, 2);
  ASSERT_EQ(robot.centres.size(), 1u);  // the elbow: both joints turn across the arm
  EXPECT_EQ(robot.centres[0].frame, 1);
}

TEST(Urdf, CoupledJointsThroughOneAnother) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotTable robot = written_robot("two", kDescription);
  const JointVector q = (JointVector(2) << 0.3, -0.7).finished();
  std::vector<Pose> frames;
  forward(robot, q, frames);
  const Mat4 stand_from_a = shift(0, 0, 1) * rotation(2, 0.3) * rotation(1, 0.2) * rotation(0, 0.1);
  const Mat4 lower = stand_from_a * rotation(1, 0.3) * shift(0, 0, 0.4) * rotation(1, -0.7);
  const double d = -0.3 + 0.25, c = 2 * d + 0.5;
  EXPECT_LT((tip_pose(robot, frames, 0).matrix() -
             lower * shift(0, 0, 0.3) * rotation(0, c) * shift(0, 0, 0.1))
                .cwiseAbs()
                .maxCoeff(),
            1e-14);
  EXPECT_LT((frames[4].matrix() - lower * shift(0, 0, 0.1) * rotation(2, d)).cwiseAbs().maxCoeff(),
            1e-14);
}

TEST(Urdf, ShapesAreHeldByCapsulesAndSrdfAllowsPairs) {
  write_text("two.urdf", kUrdf);
  write_text("two.srdf", kSrdf);
  const RobotTable robot = written_robot("two", kDescription);
  std::vector<std::string> names;
  for (const auto& capsule : robot.capsules) names.push_back(capsule.name);
  ASSERT_THAT(names, ElementsAre("stand", "upper", "ball"));
  EXPECT_EQ(robot.capsules[0].frame, -1);
  EXPECT_EQ((robot.capsules[0].to - robot.capsules[0].from).cwiseAbs(), Vec3(0, 0.4, 0));
  EXPECT_NEAR(robot.capsules[0].radius, 0.05 * std::sqrt(2), 1e-15);
  EXPECT_LT((robot.capsules[1].from - Vec3(0, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(robot.capsules[2].from, robot.capsules[2].to);
  EXPECT_TRUE(robot.capsules[2].may_touch_target);
  EXPECT_FALSE(robot.capsules[1].may_touch_target);
  using Pair = std::array<int, 2>;
  EXPECT_THAT(robot.allowed_pairs, ElementsAre(Pair{0, 1}, Pair{0, 2}, Pair{1, 2}));
}

/// Whatever the shape, every point of it lies in one of the capsules that stand for it.
TEST(Urdf, NoPointOfAShapeIsOutsideItsCapsules) {
  std::mt19937 random(3);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  for (int i = 0; i < 200; ++i) {
    const Vec3 size(number(0.005, 0.5), number(0.005, 0.5), number(0.005, 0.5));
    const bool box = i % 2 == 0;
    const std::string geometry =
        box ? fmt::format("<box size=\"{} {} {}\"/>", size.x(), size.y(), size.z())
            : fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", size.x(), size.z());
    std::string urdf = kUrdf;
    const std::string old = "<box size=\"0.1 0.4 0.1\"/>";
    urdf.replace(urdf.find(old), old.size(), geometry);
    write_text("two.urdf", urdf);
    write_text("two.srdf", kSrdf);
    const RobotTable robot = written_robot("two", kDescription);
    for (int k = 0; k < 100; ++k) {
      Vec3 point(number(-1, 1), number(-1, 1), number(-1, 1));
      point[k % 3] = point[k % 3] < 0 ? -1 : 1;  // on a face
      if (box) {
        point = 0.5 * point.cwiseProduct(size);
      } else {
        const double angle = number(0, 2 * std::numbers::pi);
        point = Vec3(size.x() * std::cos(angle), size.x() * std::sin(angle),
                     0.5 * size.z() * point.z());
      }
      double outside = 1;
      for (const RobotTable::Capsule& capsule : robot.capsules) {
        if (capsule.frame >= 0) continue;
        const Vec3 axis = capsule.to - capsule.from;
        const double t =
            axis.isZero(0)
                ? 0
                : std::clamp((point - capsule.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
        outside = std::min(outside, (point - capsule.from - t * axis).norm() - capsule.radius);
      }
      ASSERT_LT(outside, 1e-12) << geometry;
    }
  }
}

TEST(Urdf, MeshesAreLeftOutOnlyIfOneSaysSo) {
  std::string urdf = kUrdf;
  const std::string old = "<sphere radius=\"0.06\"/>";
  urdf.replace(urdf.find(old), old.size(), "<mesh filename=\"package://x/y.stl\"/>");
  write_text("two.srdf", kSrdf);
  const std::filesystem::path file = write_text("two.urdf", urdf);
  std::string yaml = kDescription;
  yaml.erase(yaml.find("collision:"));
  try {
    written_robot("two", yaml);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + ":28: link lower.collision: is a mesh"));
  }
  yaml.replace(yaml.find("  srdf"), 0, "  meshes: ignore\n");
  const RobotDescription description = load_robot(write_robot("two", yaml));
  EXPECT_EQ(description.table.capsules.size(), 2u);
  ASSERT_EQ(description.notes.size(), 1u);
  EXPECT_THAT(description.notes[0],
              HasSubstr("two.urdf:28: link lower.collision: a mesh, left out"));
}

}  // namespace
}  // namespace morphe::robot
