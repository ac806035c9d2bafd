#include "stages/grasp/surface_contact_term.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/files/description.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/grasp/constants.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"

namespace morphe::grasp {
namespace {

/// A posture of the robot for residuals.
class TermPosture final : public ResidualInput {
 public:
  TermPosture(const robot::Robot& model, const JointVector& at, const std::vector<Pose>& frames,
              const std::vector<Vec3>& goals, const Vec3& unknown)
      : ResidualInput(model, at, frames, goals, unknown, unknown, unknown) {}

  Eigen::Matrix3Xd point_jacobian(int frame, const Vec3& point_in_base) const override {
    Eigen::Matrix3Xd jacobian(3, q.size());
    robot::point_jacobian(robot, base_from_frame, frame, point_in_base, jacobian);
    return jacobian;
  }
};

/// The reference robot, and a sphere of 30 mm radius near its thumb and index.
struct NearSphere {
  robot::Robot robot{
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table};
  JointVector q = 0.5 * (robot.lower + robot.upper);
  SceneObject ball;
  std::vector<DesiredContact> contacts;

  explicit NearSphere(double slide_m = 0) {
    ball.shape = Shape::sphere;
    ball.size = {0.03};
    ball.time = {0};
    std::vector<Pose> frames;
    robot::forward_kinematics(robot, q, frames);
    const auto pad = [&](std::size_t tip) {
      return Vec3(robot::tracked_point(robot, frames, static_cast<std::ptrdiff_t>(tip), 1));
    };
    ball.position = {0.5 * (pad(0) + pad(1)) + Vec3(0.02, -0.01, 0.015)};
    ball.orientation = {Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()))};
    for (const std::size_t tip : {0U, 1U}) {
      DesiredContact contact;
      contact.tip = tip;
      contact = project_contact(robot, ball, pose().inverse() * pad(tip), contact);
      const Vec3 aside = contact.normal.unitOrthogonal();
      contact.demonstrated = nearest_surface(ball, contact.point + slide_m * aside).point;
      contacts.push_back(contact);
    }
  }
  Pose pose() const {
    Pose pose = Pose::Identity();
    pose.translate(ball.position[0]).rotate(ball.orientation[0]);
    return pose;
  }
  JointVector residuals(const JointVector& at, JointRows& jacobian) const {
    std::vector<Pose> frames;
    robot::forward_kinematics(robot, at, frames);
    const std::vector<Vec3> goals(robot.tips.size(), unknown_point());
    const Vec3 unknown = unknown_point();
    JointVector r;
    const SurfaceContactTerm term(robot, contacts, ball, pose());
    term.residuals(TermPosture(robot, at, frames, goals, unknown), r, jacobian);
    return r;
  }
};

TEST(SurfaceContactTerm, TheJacobianIsThatOfFiniteDifferences) {
  for (const double slide_m : {0.0, 0.025}) {
    const NearSphere near(slide_m);
    JointRows jacobian, unused;
    const JointVector r = near.residuals(near.q, jacobian);
    ASSERT_EQ(r.size(), 10);
    EXPECT_EQ(r[4] > 0, slide_m > kMaxSlide_m) << "the slide costs beyond its limit only";
    for (Eigen::Index joint = 0; joint < near.q.size(); ++joint) {
      JointVector before = near.q, after = near.q;
      before[joint] -= 1e-6;
      after[joint] += 1e-6;
      const JointVector slope =
          (near.residuals(after, unused) - near.residuals(before, unused)) / 2e-6;
      for (Eigen::Index row = 0; row < r.size(); ++row)
        EXPECT_NEAR(jacobian(row, joint), slope[row], 0.01 * (1 + std::abs(slope[row])))
            << joint << " " << row;
    }
  }
}

TEST(SurfaceContactTerm, ResidualsAreGapAndDirection) {
  const NearSphere near;
  JointRows jacobian;
  const JointVector r = near.residuals(near.q, jacobian);
  std::vector<Pose> frames;
  robot::forward_kinematics(near.robot, near.q, frames);
  for (int c = 0; c < 2; ++c) {
    const robot::Pad& pad = near.robot.pads[static_cast<std::size_t>(c)];
    const Pose& base_from_tip =
        frames[static_cast<std::size_t>(near.robot.tips[static_cast<std::size_t>(c)].frame)];
    const Vec3 to_ball = near.ball.position[0] - base_from_tip * pad.centre;
    EXPECT_NEAR(r[5 * c], std::sqrt(kGapWeight) * (to_ball.norm() - 0.03 - pad.radius), 1e-6);
    const double cosine = to_ball.normalized().dot(base_from_tip.linear() * pad.direction);
    EXPECT_NEAR(r.segment<3>(5 * c + 1).squaredNorm(), kPadDirectionWeight * (2 - 2 * cosine),
                1e-6);
  }
}

TEST(SurfaceContactTerm, AFingerThatClosesByItselfMaySlideAnywhere) {
  NearSphere near(0.025);
  JointRows jacobian;
  const JointVector limited = near.residuals(near.q, jacobian);
  for (DesiredContact& contact : near.contacts) contact.demonstrated = unknown_point();
  const JointVector free = near.residuals(near.q, jacobian);
  for (const Eigen::Index row : {4, 9}) {
    EXPECT_GT(limited[row], 0);
    EXPECT_EQ(free[row], 0);
    EXPECT_TRUE(jacobian.row(row).isZero());
  }
  EXPECT_EQ(free.head<4>(), limited.head<4>());
}

}  // namespace
}  // namespace morphe::grasp
