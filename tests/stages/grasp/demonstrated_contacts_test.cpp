#include "stages/grasp/demonstrated_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/files/description.hpp"
#include "tests/core/collision/meshes.hpp"

namespace morphe::grasp {
namespace {

const robot::Robot& reference() {
  static const robot::Robot robot(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml").table);
  return robot;
}

/// A cylinder of 30 mm radius that thumb and index hold, a pad's depth from it; the middle finger
/// stays 30 mm away, ring and little were not seen.
struct HeldCylinder {
  SceneObject target;
  Movement movement;
  Goals goals;
  GraspOptions options;
  Quat turn = Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()));
  Vec3 place = Vec3(0.3, 0.5, 0.2);

  HeldCylinder() {
    target.name = "cup";
    target.shape = Shape::cylinder;
    target.size = {0.03, 0.1};
    target.time = {0};
    target.position = {place};
    target.orientation = {turn};
    movement.end_s = 2;
    movement.target = "cup";
    movement.phases = {{PhaseKind::reach, 0, 1},
                       {PhaseKind::preshape, 0.4, 1},
                       {PhaseKind::grasp, 1, 1.5},
                       {PhaseKind::hold, 1.5, 2}};
    const std::size_t frames = 201;
    goals.tip_position = {frames, 5, unknown_point()};
    goals.tip_orientation = {frames, 5, unknown_rotation()};
    for (std::size_t f = 0; f < frames; ++f) {
      const double t = 0.01 * static_cast<double>(f);
      goals.time.push_back(t);
      const double away = t < 1 ? 0.1 * (1 - t) : 0;
      goals.tip_position(f, 0) = in_base({-0.041 - away, 0, 0.01});
      goals.tip_position(f, 1) = in_base({0, 0.041 + away, -0.02});
      goals.tip_position(f, 2) = in_base({0, 0.06 + away, 0});
    }
  }
  Vec3 in_base(const Vec3& in_target) const { return place + turn * in_target; }
  std::vector<DesiredContact> touches() const {
    return demonstrated_contacts(reference(), goals, movement, target, options);
  }
};

TEST(DemonstratedTouches, AreWhereSkinMeetsTheSurface) {
  const HeldCylinder held;
  const std::vector<DesiredContact> touches = held.touches();
  ASSERT_EQ(touches.size(), 2U);
  EXPECT_EQ(touches[0].tip, 0U);
  EXPECT_LT((touches[0].point - Vec3(-0.03, 0, 0.01)).norm(), 1e-12);
  EXPECT_LT((touches[0].normal - Vec3(1, 0, 0)).norm(), 1e-12) << "inwards";
  EXPECT_LT((touches[0].centre - Vec3(-0.041, 0, 0.01)).norm(), 1e-12) << "a radius outside";
  EXPECT_LT((touches[1].point - Vec3(0, 0.03, -0.02)).norm(), 1e-12);
  EXPECT_NEAR(touches[0].confidence, 1, 1e-9);
}

TEST(DemonstratedTouches, NeedTheSkinToBeNearForHalfOfTheTime) {
  HeldCylinder held;
  for (std::size_t f = 100; f < held.goals.frames(); ++f) {
    if (f % 5 < 3) held.goals.tip_position(f, 0) = held.in_base({-0.053, 0, 0.01});
  }
  EXPECT_EQ(held.touches().size(), 1U);
  held.options.touch_distance_m = 0.013;
  ASSERT_EQ(held.touches().size(), 2U);
  EXPECT_LT(held.touches()[0].confidence, 0.9);
}

/// What a person touches who holds that shape where the cylinder was.
std::vector<DesiredContact> touches_of(HeldCylinder held, const SceneObject& shape,
                                       const collision::MeshSolid* mesh) {
  SceneObject target = shape;
  target.time = held.target.time;
  target.position = held.target.position;
  target.orientation = held.target.orientation;
  return demonstrated_contacts(reference(), held.goals, held.movement, {target, mesh},
                               held.options);
}

TEST(DemonstratedTouches, OfAMeshAreThoseOfTheBoxThatItIs) {
  const HeldCylinder held;
  SceneObject box;
  box.name = "cup";
  box.shape = Shape::box;
  box.size = {0.06, 0.06, 0.1};
  const collision::MeshObject mesh = collision::box_mesh({0.06, 0.06, 0.1});
  const std::vector<DesiredContact> of_box = touches_of(held, box, nullptr),
                                    of_mesh = touches_of(held, mesh, mesh.solid.get());
  ASSERT_EQ(of_box.size(), 2U);
  ASSERT_EQ(of_mesh.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(of_mesh[i].tip, of_box[i].tip);
    EXPECT_LT((of_mesh[i].point - of_box[i].point).norm(), 1e-12);
    EXPECT_LT((of_mesh[i].normal - of_box[i].normal).norm(), 1e-12);
    EXPECT_LT((of_mesh[i].centre - of_box[i].centre).norm(), 1e-12);
    EXPECT_NEAR(of_mesh[i].confidence, of_box[i].confidence, 1e-9);
  }
}

TEST(DemonstratedTouches, OfARingAreOnItsTubeWhereTheSkinIs) {
  HeldCylinder held;  // a ring about z: the thumb inside of it, the index outside
  const double ring = 0.045, tube = 0.01;
  for (std::size_t f = 100; f < held.goals.frames(); ++f) {
    held.goals.tip_position(f, 0) = held.in_base({-(ring - tube - 0.011), 0, 0});
    held.goals.tip_position(f, 1) = held.in_base({0, ring + tube + 0.011, 0});
  }
  const collision::MeshObject mesh = collision::torus_mesh(ring, tube, 96, 48);
  const std::vector<DesiredContact> touches = touches_of(held, mesh, mesh.solid.get());
  ASSERT_EQ(touches.size(), 3U) << "the middle finger beside them, 60 mm from the middle";
  EXPECT_LT((touches[0].point - Vec3(-(ring - tube), 0, 0)).norm(), 5e-4);
  EXPECT_LT((touches[0].normal - Vec3(-1, 0, 0)).norm(), 0.1) << "into the tube, outwards";
  EXPECT_LT((touches[1].point - Vec3(0, ring + tube, 0)).norm(), 1e-4);
  EXPECT_LT((touches[1].normal - Vec3(0, -1, 0)).norm(), 0.1);
}

TEST(MakeRoom, MovesPadsApartAlongTheSurfaceAndNoFurther) {
  HeldCylinder held;
  for (std::size_t f = 0; f < held.goals.frames(); ++f) {
    held.goals.tip_position(f, 2) = held.goals.tip_position(f, 1) + held.turn * Vec3(0, 0, 0.018);
  }
  std::vector<DesiredContact> touches = held.touches();
  ASSERT_EQ(touches.size(), 3U);
  const std::vector<DesiredContact> before = touches;
  separate_contacts(reference(), held.target, 0.001, touches);
  EXPECT_EQ(touches[0].point, before[0].point) << "the thumb has room";
  EXPECT_NEAR((touches[2].centre - touches[1].centre).norm(), 0.023, 2e-4);
  EXPECT_LT((touches[1].point - Vec3(0, 0.03, -0.0225)).norm(), 2e-4) << "half of 5 mm each";
  EXPECT_LT((touches[2].point - Vec3(0, 0.03, 0.0005)).norm(), 2e-4);
  for (const DesiredContact& touch : touches) {
    EXPECT_NEAR(touch.point.head<2>().norm(), 0.03, 1e-9) << "on the surface";
  }
}

TEST(AimPads, TakeGoalsFromTipsToPadsOverThePreshape) {
  HeldCylinder held;
  const Goals before = held.goals;
  set_pad_goals(reference(), held.touches(), held.movement, held.target, 0.01, held.goals);
  for (std::size_t f = 0; f < before.frames(); ++f) {
    const double t = before.time[f], share = held.goals.tip_to_pad_share(f, 0);
    if (t <= 0.4) {
      EXPECT_EQ(share, 0);
      EXPECT_EQ(held.goals.tip_position(f, 0), before.tip_position(f, 0));
    } else if (t >= 1) {
      EXPECT_EQ(share, 1);
      EXPECT_LT((held.goals.tip_position(f, 0) - held.in_base({-0.041, 0, 0.01})).norm(), 1e-12);
    }
    EXPECT_EQ(held.goals.tip_to_pad_share(f, 2), 0) << "the middle finger did not touch";
    EXPECT_GE(share, held.goals.tip_to_pad_share(f > 0 ? f - 1 : 0, 0));
  }
  EXPECT_NEAR(held.goals.tip_to_pad_share(70, 0), 0.5, 1e-9) << "half-way through the preshape";
}

TEST(AimPads, KeepGoalsOutsideTheTargetByTheApertureOnTheirWay) {
  HeldCylinder held;
  for (std::size_t f = 50; f < 100; ++f) {  // the index comes right through the cylinder
    held.goals.tip_position(f, 1) = held.in_base({0, 0.041 - 2 * 0.01 * double(100 - f) * 0.08, 0});
  }
  set_pad_goals(reference(), held.touches(), held.movement, held.target, 0.01, held.goals);
  for (std::size_t f = 50; f < 100; ++f) {
    const Vec3 at = held.turn.inverse() * (held.goals.tip_position(f, 1) - held.place);
    const double apart = at.head<2>().norm() - 0.03;
    const double share = held.goals.tip_to_pad_share(f, 1);
    EXPECT_GE(apart, std::sqrt(share) * 0.011 + 4 * share * (1 - share) * 0.01 - 1e-9)
        << held.goals.time[f];
  }
}

TEST(MovedTo, TouchesTheNearestPointOfTheSurface) {
  const HeldCylinder held;
  DesiredContact touch = held.touches()[1];
  touch = project_contact(reference(), held.target, {0.05, 0, 0.02}, touch);
  EXPECT_EQ(touch.tip, 1U);
  EXPECT_LT((touch.point - Vec3(0.03, 0, 0.02)).norm(), 1e-12);
  EXPECT_LT((touch.normal - Vec3(-1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((touch.centre - Vec3(0.041, 0, 0.02)).norm(), 1e-12) << "a radius outside";
}

TEST(KeepOutside, TakesGoalsAsFarOutAsThePadIsThickAndLeavesOthers) {
  HeldCylinder held;
  for (std::size_t f = 0; f < held.goals.frames(); ++f) {
    held.goals.tip_position(f, 0) = held.in_base({-0.028, 0, 0.01});  // 2 mm inside
  }
  const Goals before = held.goals;
  keep_goals_outside(reference(), {0, 2, 3}, held.movement, held.target, held.goals);
  for (std::size_t f = 0; f < before.frames(); ++f) {
    const double share = closing_progress(hold_interval(held.movement), before.time[f]);
    const Vec3 at = held.turn.inverse() * (held.goals.tip_position(f, 0) - held.place);
    if (share > 0) {
      EXPECT_NEAR(at.x(), -0.03 - std::sqrt(share) * 0.011, 1e-9) << before.time[f];
    } else {
      EXPECT_EQ(held.goals.tip_position(f, 0), before.tip_position(f, 0));
    }
    EXPECT_EQ(held.goals.tip_position(f, 1), before.tip_position(f, 1)) << "not asked for";
    EXPECT_EQ(held.goals.tip_position(f, 2), before.tip_position(f, 2)) << "outside already";
    EXPECT_FALSE(is_known(held.goals.tip_position(f, 3))) << "never seen";
  }
}

TEST(ClosedShare, FallsAgainAfterTheRelease) {
  Movement movement;
  movement.end_s = 5;
  movement.phases = {{PhaseKind::reach, 0, 1},
                     {PhaseKind::grasp, 1, 1.2},
                     {PhaseKind::transport, 1.2, 3},
                     {PhaseKind::return_phase, 3, 5}};
  const HoldInterval when = hold_interval(movement);
  EXPECT_EQ(closing_progress(when, 1 - kReleaseDuration_s), 0)
      << "no preshape: as long as letting go";
  EXPECT_EQ(closing_progress(when, 1), 1);
  EXPECT_EQ(closing_progress(when, 3), 1);
  EXPECT_NEAR(closing_progress(when, 3 + kReleaseDuration_s / 2), 0.5, 1e-12);
  EXPECT_EQ(closing_progress(when, 3 + kReleaseDuration_s), 0);
  EXPECT_EQ(closing_progress(hold_interval(Movement{}), 1), 0) << "nothing is grasped";
}

}  // namespace
}  // namespace morphe::grasp
