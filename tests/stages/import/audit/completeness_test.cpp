#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

/// A minimum-jerk reach of 0.4 m from 1 s to 2 s, of wrist and index tip, recorded at 100 Hz from
/// `begin_s` to `end_s`. The movement is the part of the reach that was recorded.
struct RecordedReach {
  Demonstration recording;
  HumanMotion motion;
  Movement movement;

  RecordedReach(double begin_s, double end_s) {
    const auto frames = static_cast<std::size_t>(std::lround(100 * (end_s - begin_s))) + 1;
    motion.tip = {frames, kFingerCount, unknown_point()};
    for (std::size_t f = 0; f < frames; ++f) {
      const double time_s = begin_s + 0.01 * static_cast<double>(f);
      const double u = std::clamp(time_s - 1, 0.0, 1.0);
      const Vec3 point(0, 0.4 * u * u * u * (10 - 15 * u + 6 * u * u), 0);
      motion.time.push_back(time_s);
      motion.wrist.push_back(point);
      motion.tip(f, kIndex) = point + Vec3(0, 0.15, 0);
    }
    movement.begin_s = std::max(begin_s, 1.0);
    movement.end_s = std::min(end_s, 2.0);
    movement.phases = {{PhaseKind::reach, movement.begin_s, movement.end_s}};
  }
  std::vector<RecordingFlag> flags() const {
    return check_completeness({recording, motion, movement}, {});
  }
};

TEST(Completeness, AReachFromRestToRestIsComplete) {
  EXPECT_TRUE(RecordedReach(0, 3).flags().empty());
  EXPECT_TRUE(RecordedReach(1, 2).flags().empty()) << "cut where it begins and ends";
}

TEST(Completeness, AReachCutInMotionIsNot) {
  const auto at_end = RecordedReach(0, 1.6).flags();
  ASSERT_EQ(at_end.size(), 1u);
  EXPECT_EQ(at_end[0].code, FlagCode::incomplete_movement);
  EXPECT_NEAR(at_end[0].begin_s, 1.6, 1e-9);
  EXPECT_NEAR(at_end[0].value, 0.93, 0.05) << "16 u^2 (1 - u)^2 of the highest speed, 25 ms before";
  EXPECT_THAT(at_end[0].text, testing::StartsWith("the recording ends while the hand moves"));
  const auto at_begin = RecordedReach(1.3, 3).flags();
  ASSERT_EQ(at_begin.size(), 1u);
  EXPECT_NEAR(at_begin[0].begin_s, 1.3, 1e-9);
  EXPECT_THAT(at_begin[0].text, testing::StartsWith("the recording begins while the hand moves"));
}

TEST(Completeness, ACutBeforeTheHighestSpeedIsSeenToo) {
  EXPECT_EQ(RecordedReach(0, 1.3).flags().size(), 1u);
  EXPECT_EQ(RecordedReach(1.4, 1.7).flags().size(), 2u) << "at both ends";
}

TEST(Completeness, TheLastPartOfAReachMayBeMissing) {
  EXPECT_TRUE(RecordedReach(0, 1.93).flags().empty()) << "1.3 mm are missing";
  EXPECT_EQ(RecordedReach(0, 1.8).flags().size(), 1u) << "23 mm are missing";
}

TEST(Completeness, AHandThatDisappearsInMotionEndsThere) {
  RecordedReach of(0, 3);
  of.movement.end_s = 1.6;
  EXPECT_TRUE(of.flags().empty()) << "seen further on: a gap, or the end of what is planned";
  for (std::size_t f = 0; f < of.motion.time.size(); ++f)
    if (of.motion.time[f] > 1.6) of.motion.wrist[f] = of.motion.tip(f, kIndex) = unknown_point();
  EXPECT_EQ(of.flags().size(), 1u);
  for (Vec3& wrist : of.motion.wrist) wrist = unknown_point();
  EXPECT_EQ(of.flags().size(), 1u) << "by the fingertip";
}

/// Adds the way back to where the hand was at 1 s, from `from_s` on; then the hand rests.
void add_return(double from_s, RecordedReach& of) {
  for (std::size_t f = 0; f < of.motion.time.size(); ++f) {
    const double u = std::clamp(of.motion.time[f] - from_s, 0.0, 1.0);
    const Vec3 back(0, -0.4 * u * u * u * (10 - 15 * u + 6 * u * u), 0);
    of.motion.wrist[f] += back;
    of.motion.tip(f, kIndex) += back;
  }
  of.movement.begin_s = from_s;
  of.movement.end_s = from_s + 1;
  of.movement.phases = {{PhaseKind::reach, from_s, from_s + 1}};
}

TEST(Completeness, AMovementAfterACutOneNeedsARestBefore) {
  RecordedReach soon(1.5, 6), later(1.5, 6), complete(0, 6);
  add_return(2.2, soon);
  EXPECT_EQ(soon.flags().size(), 1u) << "the way back is no reach of its own";
  add_return(3.6, later);
  EXPECT_TRUE(later.flags().empty());
  add_return(2.2, complete);
  EXPECT_TRUE(complete.flags().empty());
}

TEST(Completeness, ALaterMotionThatIsQuickerDoesNotHideACut) {
  RecordedReach of(1.13, 6);
  for (std::size_t f = 0; f < of.motion.time.size(); ++f) {
    const double u = std::clamp((of.motion.time[f] - 3) / 0.5, 0.0, 1.0);
    of.motion.wrist[f] += Vec3(0, 0, 1.0 * u * u * u * (10 - 15 * u + 6 * u * u));
  }
  of.movement.end_s = 3.5;
  EXPECT_EQ(of.flags().size(), 1u) << "0.2 m/s at the cut, of 0.75 m/s then and 3.75 m/s later";
}

TEST(Completeness, AWholeRecordingIsTakenAsItIs) {
  RecordedReach of(1.3, 1.6);
  of.movement.phases.clear();
  EXPECT_TRUE(of.flags().empty());
}

}  // namespace
}  // namespace morphe::imports
