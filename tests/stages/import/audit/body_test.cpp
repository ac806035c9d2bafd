#include <gmock/gmock.h>

#include <array>

#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/hand_side.hpp"
#include "stages/import/recording/conventions.hpp"
#include "tests/stages/import/audit/table_trials.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

void transform(const Eigen::Matrix3d& map, Streams& streams) {
  if (!streams.markers) return;
  for (Vec3& point : streams.markers->position.values) point = map * point;
}

/// A trial whose points were all mapped, those of the static trial too.
Demonstration mapped(Demonstration trial, const Eigen::Matrix3d& map) {
  transform(map, trial.streams);
  transform(map, trial.calibration);
  return trial;
}

Eigen::Matrix3d turned(double degrees, const Vec3& axis) {
  return Eigen::AngleAxisd(degrees * kRadPerDegree, axis).toRotationMatrix();
}

std::vector<FlagCode> codes_of(const std::vector<Doubt>& doubts) {
  std::vector<FlagCode> codes;
  for (const Doubt& doubt : doubts) codes.push_back(doubt.flag.code);
  return codes;
}

/// A hand whose fingers are bent to the palm by 30 mm: of the right one, fingers along Y, thumb
/// at -X, palm down.
Demonstration bent_hand(bool mirrored) {
  Demonstration recording;
  HandStream& hand = recording.streams.hand.emplace();
  hand.kind = HandKind::keypoints;
  hand.time = {0, 0.1};
  hand.position = {2, 21, Vec3::Zero()};
  for (std::size_t row = 0; row < 2; ++row) {
    for (int finger = 0; finger < 5; ++finger) {
      for (int joint = 0; joint < 4; ++joint) {
        const double x = -0.04 + 0.02 * finger;
        hand.position(row, 1 + 4 * finger + joint) =
            Vec3(mirrored ? -x : x, finger == 0 ? 0.03 : 0.08 + 0.02 * joint, -0.01 * joint);
      }
    }
  }
  return recording;
}

TEST(AuditBody, NoShippedRecordingIsDoubted) {
  for (const char* folder :
       {"ue-adl", "adroit-dapg", "aria", "cmu-iclone-bvh", "cmu-native", "dex-retargeting",
        "kineticstoolkit", "optitrack", "pybvh", "pyomeca"}) {
    for (const Demonstration& recording : shipped_recordings(folder)) {
      for (const auto check :
           {check_chirality, check_vertical, check_scale, check_static_trial, check_objects}) {
        const std::vector<Doubt> doubts = check(recording, {});
        EXPECT_THAT(doubts, IsEmpty()) << recording.name << ": " << doubts.front().flag.text;
      }
    }
  }
}

TEST(AuditBody, AMirroredBodyIsAskedWithTheAxesThatMirrorItBack) {
  for (const Demonstration& trial : table_trials()) {
    for (const char* axes : {"-x y z", "x -y z", "x y -z", "y x z", "x z y"}) {
      const Eigen::Matrix3d mirror = world_from_points(axes, "").transpose();
      const std::vector<Doubt> doubts = check_chirality(mapped(trial, mirror), {});
      ASSERT_THAT(codes_of(doubts), ElementsAre(FlagCode::mirrored)) << trial.name << axes;
      ASSERT_TRUE(doubts[0].question);
      EXPECT_EQ(doubts[0].question->key, "axes");
      EXPECT_EQ(doubts[0].question->value, axes) << trial.name;
    }
  }
}

TEST(AuditBody, StatedAxesAreNotAskedAgain) {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(-1, 1, 1).asDiagonal();
  const Demonstration mirrored = mapped(table_trials()[0], mirror);
  EXPECT_FALSE(check_chirality(mirrored, {.axes_given = true}).at(0).question);
  const Demonstration lying = mapped(table_trials()[0], turned(90, Vec3::UnitX()));
  EXPECT_FALSE(check_vertical(lying, {.axes_given = true}).at(0).question);
}

TEST(AuditBody, ALyingBodyIsAskedForItsVertical) {
  for (const Demonstration& trial : table_trials()) {
    for (const auto& [axis, degrees, up] : {std::tuple(Vec3(1, 0, 0), 90.0, "-y"),
                                            {Vec3(1, 0, 0), -90.0, "y"},
                                            {Vec3(1, 0, 0), 180.0, "-z"},
                                            {Vec3(0, 1, 0), 90.0, "x"},
                                            {Vec3(0, 1, 0), -90.0, "-x"}}) {
      const std::vector<Doubt> doubts = check_vertical(mapped(trial, turned(degrees, axis)), {});
      ASSERT_THAT(codes_of(doubts), ElementsAre(FlagCode::vertical)) << trial.name << up;
      ASSERT_TRUE(doubts[0].question) << trial.name << up;
      EXPECT_TRUE(doubts[0].question->value.ends_with(std::string(" ") + up))
          << trial.name << " " << doubts[0].question->value;
    }
  }
}

TEST(AuditBody, ATiltedLaboratoryIsFlagged) {
  for (const Demonstration& trial : table_trials()) {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
      for (const double degrees : {-45.0, 45.0}) {
        const auto doubts = check_vertical(mapped(trial, turned(degrees, axis)), {});
        EXPECT_THAT(codes_of(doubts), ElementsAre(FlagCode::vertical)) << trial.name << degrees;
      }
    }
    for (const double degrees : {-15.0, 15.0}) {  // to the side, which the shoulders tell
      const auto doubts = check_vertical(mapped(trial, turned(degrees, Vec3::UnitY())), {});
      EXPECT_THAT(codes_of(doubts), ElementsAre(FlagCode::vertical)) << trial.name << degrees;
    }
  }
}

TEST(AuditBody, TheHandClosesToItsPalm) {
  EXPECT_NEAR(palmward_tips_m(bent_hand(false)), 0.03, 1e-12);
  EXPECT_NEAR(palmward_tips_m(bent_hand(true)), -0.03, 1e-12);
  EXPECT_THAT(check_chirality(bent_hand(false), {}), IsEmpty());
  const std::vector<Doubt> doubts = check_chirality(bent_hand(true), {});
  ASSERT_THAT(codes_of(doubts), ElementsAre(FlagCode::mirrored));
  EXPECT_EQ(doubts[0].question->key, "hand");
  EXPECT_EQ(doubts[0].question->value, "left");
  const AuditInput stated{.axes_given = true, .hand_given = true};
  EXPECT_FALSE(check_chirality(bent_hand(true), stated).at(0).question);
}

TEST(AuditBody, AHandWithStretchedFingersDoesNotTellItsSide) {
  Demonstration flat = bent_hand(true);
  for (Vec3& point : flat.streams.hand->position.values) point.z() *= 0.5;
  EXPECT_THAT(check_chirality(flat, {}), IsEmpty());
}

TEST(AuditBody, AnotherUnitIsNoPersonsSize) {
  for (const Demonstration& trial : table_trials()) {
    for (const double factor : {10.0, 0.1, 25.4, 1 / 25.4, 2.54, 1 / 2.54, 1000.0, 0.3048}) {
      const auto doubts = check_scale(mapped(trial, factor * Eigen::Matrix3d::Identity()), {});
      ASSERT_THAT(codes_of(doubts), ElementsAre(FlagCode::scale)) << trial.name << factor;
      EXPECT_EQ(doubts[0].question->key, "unit");
      EXPECT_NEAR(doubts[0].flag.value / factor, 0.9, 0.15) << trial.name;
    }
    for (const double person : {0.75, 1.25})  // a child, and a tall adult
      EXPECT_THAT(check_scale(mapped(trial, person * Eigen::Matrix3d::Identity()), {}), IsEmpty());
  }
}

TEST(AuditBody, APalmOfTwoCentimetresHasWrongNames) {
  Demonstration recording;
  MarkerStream& markers = recording.streams.markers.emplace();
  markers.names = {"right_wrist", "right_index_mcp", "right_index_tip"};
  markers.time = {0};
  markers.position = {1, 3, Vec3::Zero()};
  markers.position(0, 1) = {0, 0.02, 0};
  markers.position(0, 2) = {0, 0.12, 0};
  const std::vector<Doubt> doubts = check_scale(recording, {});
  ASSERT_THAT(codes_of(doubts), ElementsAre(FlagCode::scale));
  EXPECT_EQ(doubts[0].flag.subject, "palm");
  EXPECT_NEAR(doubts[0].flag.value, 0.02 / 0.095, 1e-12);
}

}  // namespace
}  // namespace morphe::imports
