#include "pipeline/study/held_objects.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace morphe::study {
namespace {

constexpr double kPad_m = 0.011;

/// Thumb against index and middle finger, 60 mm apart, a metre above the table.
ObservedHand pinching_hand() {
  ObservedHand hand;
  hand.tip.fill(unknown_point());
  hand.middle_joint.fill(unknown_point());
  hand.tip[kThumb] = {0.30, 0.40, 1.00};
  hand.tip[kIndex] = {0.36, 0.41, 1.01};
  hand.tip[kMiddle] = {0.36, 0.40, 0.99};
  for (const std::size_t finger : {kThumb, kIndex, kMiddle}) {
    hand.middle_joint[finger] = hand.tip[finger] + Vec3(0, 0.03, 0);
  }
  return hand;
}

/// How far a point lies from a surface and along which way it goes inwards, in closed form.
double off_surface(const SceneObject& object, const KnownContact& contact) {
  const Vec3& p = contact.point;
  switch (object.shape) {
    case Shape::sphere:
      return std::abs(p.norm() - object.size[0]) + (contact.normal + p.normalized()).norm();
    case Shape::cylinder: {
      const Vec3 out(p.x(), p.y(), 0);
      const double beyond = std::max(0.0, std::abs(p.z()) - 0.5 * object.size[1]);
      return std::abs(out.norm() - object.size[0]) + beyond +
             (contact.normal + out.normalized()).norm();
    }
    default: {
      const Vec3 half = 0.5 * Vec3(object.size[0], object.size[1], object.size[2]);
      const double beyond = (p.cwiseAbs() - half).maxCoeff();  // 0 on a face
      const Vec3 out(0, 0, p.z() > 0 ? 1 : -1);
      return std::abs(beyond) + std::abs(std::abs(p.z()) - half.z()) +
             (contact.normal + out).norm();
    }
  }
}

class HeldObjects : public testing::TestWithParam<Shape> {};

TEST_P(HeldObjects, LieAPadFromEveryTip) {
  const ObservedHand hand = pinching_hand();
  math::RandomStream random(1, "held objects");
  for (int k = 0; k < 50; ++k) {
    const std::optional<HeldObject> held = draw_held_object(GetParam(), hand, {}, kPad_m, random);
    ASSERT_TRUE(held);
    ASSERT_EQ(held->contacts.size(), 3U);
    const Pose world_from_object = recorded_pose(held->object, 0);
    for (const KnownContact& contact : held->contacts) {
      const Vec3& tip = hand.tip[contact.finger];
      EXPECT_LT((world_from_object * contact.tip - tip).norm(), 1e-12);
      EXPECT_LT((contact.tip + kPad_m * contact.normal - contact.point).norm(), 1e-12);
      EXPECT_NEAR(contact.normal.norm(), 1, 1e-12);
      EXPECT_LT(off_surface(held->object, contact), 1e-9);
      EXPECT_LT(
          (world_from_object * contact.middle_joint - hand.middle_joint[contact.finger]).norm(),
          1e-12);
    }
  }
}

TEST_P(HeldObjects, AreNotDrawnTwiceAlike) {
  math::RandomStream random(1, "held objects");
  const ObservedHand hand = pinching_hand();
  const auto one = draw_held_object(GetParam(), hand, {}, kPad_m, random);
  const auto other = draw_held_object(GetParam(), hand, {}, kPad_m, random);
  ASSERT_TRUE(one && other);
  EXPECT_NE(one->object.size, other->object.size);
}

TEST_P(HeldObjects, KeepClearOfTheRestOfTheHand) {
  const ObservedHand hand = pinching_hand();
  math::RandomStream random(1, "held objects");
  const Vec3 between = 0.5 * (hand.tip[kThumb] + hand.tip[kIndex]);
  EXPECT_FALSE(draw_held_object(GetParam(), hand, {between}, kPad_m, random))
      << "all hold this point";
  const Vec3 beside = between + Vec3(0, -0.035, 0);
  for (int k = 0; k < 20; ++k) {
    const auto held = draw_held_object(GetParam(), hand, {beside}, kPad_m, random);
    if (!held) continue;
    const Vec3 p = recorded_pose(held->object, 0).inverse() * beside;
    if (held->object.shape == Shape::sphere) {
      EXPECT_GE(p.norm(), held->object.size[0] + kPad_m);
    } else if (held->object.shape == Shape::cylinder) {
      EXPECT_TRUE(p.head<2>().norm() > held->object.size[0] ||
                  std::abs(p.z()) > held->object.size[1] / 2);
    } else {
      EXPECT_GT((2 * p.cwiseAbs() -
                 Vec3(held->object.size[0], held->object.size[1], held->object.size[2]))
                    .maxCoeff(),
                0);
    }
  }
}

TEST_P(HeldObjects, DoNotReachBelowTheTable) {
  ObservedHand hand = pinching_hand();
  for (Vec3& tip : hand.tip) tip.z() -= 1.03;  // tips below its top
  math::RandomStream random(1, "held objects");
  EXPECT_FALSE(draw_held_object(GetParam(), hand, {}, kPad_m, random));
}

INSTANTIATE_TEST_SUITE_P(Shapes, HeldObjects,
                         testing::Values(Shape::sphere, Shape::cylinder, Shape::box));

/// Where the true hand is while it carries, the object is as it was taken: at its contacts.
TEST(KnownGrasp, GoesWithTheTrueHandAndStaysWhereItIsLet) {
  synthesize::SynthesizeOptions options;
  options.movements.movements_per_recording = {1, 1};
  options.movements.kinds.no_grasp = 0;
  std::size_t found = 0;
  for (std::size_t index = 0; index < 6; ++index) {
    const synthesize::SyntheticRecording made = synthesize::synthesize(options, 7, index);
    math::RandomStream random(7, "known grasp");
    const auto known = add_held_object(made, Shape::sphere, kPad_m, random);
    if (!known) continue;
    ++found;
    const SceneObject& object = known->recorded.objects.at(0);
    const auto label = [&](PhaseKind phase) {
      return *std::ranges::find(made.truth.labels, phase, &Label::phase);
    };
    const Label grasp = label(PhaseKind::grasp), lift = label(PhaseKind::transport),
                back = label(PhaseKind::return_phase);
    const std::vector<double>& time = made.truth.streams.hand->time;
    for (std::size_t i = 0; i < time.size(); ++i) {
      const bool closed = time[i] >= 0.5 * (grasp.begin_s + grasp.end_s) && time[i] < lift.end_s;
      if (!closed) continue;
      const Pose object_from_world = recorded_pose(object, time[i]).inverse();
      for (const KnownContact& contact : known->contacts) {
        const Vec3 tip = object_from_world * made.truth.streams.hand->position(i, contact.finger);
        EXPECT_LT((tip - contact.tip).norm(), 1e-9) << time[i];
      }
    }
    const Vec3 before = recorded_pose(object, time.front()).translation();
    EXPECT_EQ(before, recorded_pose(object, grasp.begin_s).translation());
    EXPECT_GT((before - recorded_pose(object, lift.end_s).translation()).norm(), 0.02);
    EXPECT_EQ(recorded_pose(object, back.begin_s + 0.05).translation(),
              recorded_pose(object, time.back()).translation());
  }
  EXPECT_GE(found, 3U);
}

}  // namespace
}  // namespace morphe::study
