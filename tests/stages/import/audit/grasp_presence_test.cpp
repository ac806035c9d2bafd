#include <gmock/gmock.h>

#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

/// A hand that goes at 0.5 m/s from stop to stop, and rests for 0.1 s at each; the phases are those
/// of a movement in which no grasp was found.
struct Course {
  HumanMotion motion;
  Movement movement;

  explicit Course(const std::vector<Vec3>& stops) {
    double now_s = 0;
    const auto rest_at = [&](const Vec3& point) {
      for (int i = 0; i < 10; ++i, now_s += 0.01) add(now_s, point);
    };
    rest_at(stops.front());
    for (std::size_t k = 1; k < stops.size(); ++k) {
      const double begin_s = now_s, length_s = (stops[k] - stops[k - 1]).norm() / 0.5;
      for (; now_s < begin_s + length_s; now_s += 0.01)
        add(now_s, stops[k - 1] + (now_s - begin_s) / length_s * (stops[k] - stops[k - 1]));
      const bool last = k + 1 == stops.size();
      movement.phases.push_back(
          {last ? PhaseKind::return_phase : PhaseKind::reach, begin_s, now_s});
      rest_at(stops[k]);
    }
    movement.begin_s = movement.phases.front().begin_s;
    movement.end_s = movement.phases.front().end_s;
  }
  void add(double time_s, const Vec3& wrist) {
    motion.time.push_back(time_s);
    motion.wrist.push_back(wrist);
    motion.shoulder.emplace_back(0.2, 0, 0.4);
  }
  std::vector<RecordingFlag> flags(const std::string& task = "") const {
    Demonstration recording;
    recording.task = task;
    return check_grasp({recording, motion, movement}, {});
  }
};

const Vec3 kHome(0.2, 0.2, 0.05), kCup(0.2, 0.4, 0.1), kMouth(0.05, 0.1, 0.5);

TEST(GraspPresence, AHandThatComesBackToTheSamePlaceIsMentioned) {
  const auto flags = Course({kHome, kCup, kMouth, kCup + Vec3(0.02, 0, 0), kHome}).flags();
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0].code, FlagCode::no_grasp);
  EXPECT_EQ(flags[0].response, FlagResponse::flagged);
  EXPECT_NEAR(flags[0].value, 1 - std::pow(0.02 / (0.5 * (kCup - kHome).norm()), 2), 0.05);
  EXPECT_THAT(flags[0].text, testing::HasSubstr("comes back to the place of its reach"));
}

TEST(GraspPresence, AStatedTaskThatTakesAnObjectIsMentioned) {
  const Course touch({kHome, kCup, kHome});
  const auto flags = touch.flags("drink");
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_THAT(flags[0].text, testing::HasSubstr("the task 'drink' takes an object"));
}

TEST(GraspPresence, TouchesOtherPlacesAndStrokesThroughTheHairAreNot) {
  EXPECT_THAT(Course({kHome, kCup, kHome}).flags("reach"), testing::IsEmpty());
  EXPECT_THAT(Course({kHome, kCup, kCup + Vec3(0.3, 0, 0), kHome}).flags(), testing::IsEmpty());
  const Vec3 down(0.03, -0.1, -0.1);
  EXPECT_THAT(Course({kHome, kMouth, kMouth + down, kMouth, kHome}).flags("comb"),
              testing::IsEmpty());
}

TEST(GraspPresence, AMovementWithAGraspIsNot) {
  Course drink({kHome, kCup, kMouth, kCup, kHome});
  drink.movement.phases[1].kind = PhaseKind::grasp;
  EXPECT_THAT(drink.flags("drink"), testing::IsEmpty());
}

TEST(GraspPresence, UnseenPointsAreNotJudged) {
  Course drink({kHome, kCup, kMouth, kCup, kHome});
  for (Vec3& wrist : drink.motion.wrist) wrist = unknown_point();
  EXPECT_THAT(drink.flags(), testing::IsEmpty());
  drink.motion.time.clear();
  EXPECT_THAT(drink.flags("drink"), testing::IsEmpty());
}

}  // namespace
}  // namespace morphe::imports
