#include "stages/reconstruct/estimated_arm.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "stages/import/import.hpp"

namespace morphe::reconstruct {
namespace {

using testing::Contains;

/// The shipped recordings of an arm by markers, rebuilt, as a skeleton without the arm: a wrist,
/// how the hand is turned, and what there is of fingers.
std::vector<std::pair<HumanMotion, Demonstration>> hidden_arms() {
  std::vector<std::pair<HumanMotion, Demonstration>> all;
  imports::ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl/recordings.yaml"};
  imports::import_recordings(request, [&](Demonstration&& recorded) {
    HumanMotion motion = reconstruct(recorded, {}, {});
    Demonstration hand;
    hand.name = recorded.name;
    hand.upper_arm = recorded.upper_arm;
    hand.forearm = recorded.forearm;
    BodyStream& body = hand.streams.skeleton.emplace();
    body.names = {"right_wrist", "right_hand", "right_thumb_tip", "right_index_tip"};
    body.parents.assign(4, "");
    body.time = motion.time;
    body.position = Array2D<Vec3>(motion.time.size(), 4, unknown_point());
    body.orientation = Array2D<Quat>(motion.time.size(), 4, unknown_rotation());
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
      body.position(i, 0) = body.position(i, 1) = motion.wrist[i];
      body.position(i, 2) = motion.tip(i, kThumb);
      body.position(i, 3) = motion.tip(i, kIndex);
      body.orientation(i, 1) = motion.wrist_orientation[i];
    }
    all.emplace_back(std::move(motion), std::move(hand));
  });
  return all;
}

double rms_between(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!is_known(a[i]) || !is_known(b[i])) continue;
    sum += (a[i] - b[i]).squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count);
}

/// Angle between the upper arms, mean over the recording [rad].
double upper_arm_error(const HumanMotion& a, const HumanMotion& b) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < a.time.size(); ++i) {
    const Vec3 u = (a.elbow[i] - a.shoulder[i]).normalized(),
               v = (b.elbow[i] - b.shoulder[i]).normalized();
    if (!is_known(u) || !is_known(v)) continue;
    sum += std::acos(std::clamp(u.dot(v), -1.0, 1.0));
    ++count;
  }
  return sum / count;
}

TEST(EstimatedArm, IsNearTheOneThatWasHidden) {
  for (const auto& [truth, hand] : hidden_arms()) {
    const HumanMotion motion = reconstruct(hand, {}, {});
    EXPECT_THAT(motion.estimated, Contains("shoulder"));
    EXPECT_THAT(motion.estimated, Contains("elbow"));
    // Every joint has a name of ours: none may be the shoulder by another.
    EXPECT_THAT(motion.reconstruction_notes,
                testing::Not(Contains(testing::HasSubstr("no joint named"))));
    const double shoulder = rms_between(motion.shoulder, truth.shoulder);
    const double elbow = rms_between(motion.elbow, truth.elbow);
    const double angle = upper_arm_error(motion, truth) / kRadPerDegree;
    const bool reach_alone = hand.name.find("DR") == std::string::npos;
    EXPECT_LT(shoulder, 0.067) << hand.name;
    EXPECT_LT(elbow, reach_alone ? 0.064 : 0.19) << hand.name;  // drinking lifts the elbow
    EXPECT_LT(angle, reach_alone ? 11 : 33) << hand.name;
  }
}

TEST(EstimatedArm, ASeenElbowWithoutShoulderIsLeft) {
  auto [truth, hand] = hidden_arms().front();
  hand.streams.skeleton->names[2] = "right_elbow";
  const HumanMotion motion = reconstruct(hand, {}, {});
  EXPECT_FALSE(is_known(motion.shoulder[10]));
  EXPECT_THAT(motion.reconstruction_notes,
              Contains(testing::HasSubstr("no joint named right_shoulder")));
}

TEST(EstimatedArm, AHeadSaysWhereTheShoulderIs) {
  auto [truth, hand] = hidden_arms().front();
  BodyStream& body = *hand.streams.skeleton;
  body.names[3] = "head";
  const double stature_m = *hand.upper_arm / 0.186;
  const Vec3 shoulder(0.2, -0.3, 0.3);
  for (std::size_t i = 0; i < body.time.size(); ++i) {
    body.position(i, 3) = shoulder + stature_m * Vec3(-0.109, 0, 0.115);
  }
  HumanOptions any_reach;
  any_reach.max_reach_share = 0.9999;
  const HumanMotion motion = reconstruct(hand, {}, any_reach);
  EXPECT_LT((motion.shoulder[0] - shoulder).norm(), 0.05);
}

TEST(EstimatedArm, LengthsComeFromTheHandWhereNothingElseSaysThem) {
  EXPECT_NEAR(arm_lengths_of({}, {}).upper_arm, 0.186 * 1.70, 1e-12);
  EXPECT_NEAR(arm_lengths_of({}, {}, 0.108 * 1.6).forearm, 0.146 * 1.6, 1e-12);
  HumanOptions tall;
  tall.stature_m = 1.9;
  EXPECT_NEAR(arm_lengths_of({}, tall, 0.108 * 1.6).upper_arm, 0.186 * 1.9, 1e-12);
  Demonstration measured;
  measured.upper_arm = 0.3;
  EXPECT_NEAR(arm_lengths_of(measured, tall, 0.1).upper_arm, 0.3, 1e-12);
}

}  // namespace
}  // namespace morphe::reconstruct
