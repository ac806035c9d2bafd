// Grasps of people who were drawn at random: found in drinks, however little the hand closes and
// however briefly it stops, and never where it touches or combs.
#include <gtest/gtest.h>

#include <array>

#include "stages/segment/segment.hpp"
#include "tests/stages/segment/everyday_tasks.hpp"

namespace morphe::segment {
namespace {

constexpr unsigned kTrials = 300, kDrinks = 150;

/// Returns the number of grasps among the movements of a trial.
std::ptrdiff_t count_grasps(const HumanMotion& motion) {
  std::ptrdiff_t grasps = 0;
  for (const Movement& movement : segment(motion, {}))
    grasps += last_phase(movement, PhaseKind::grasp) ? 1 : 0;
  return grasps;
}

/// Returns true if a trial is one movement with a grasp within 0.2 s of that of the script.
bool finds_grasp(const EverydayTask& task) {
  const std::vector<Movement> movements = segment(task.motion(), {});
  const Phase* grasp = movements.size() == 1 ? last_phase(movements[0], PhaseKind::grasp) : nullptr;
  return grasp && grasp->begin_s - 0.2 < task.grasp_s && task.grasp_s < grasp->end_s + 0.2;
}

TEST(EverydayTasks, ADrinkHasAGraspHoweverLittleTheHandClosesAndStops) {
  const std::array<std::pair<double, double>, 6> stops_and_overlaps_s = {
      {{0, 0.3}, {0, 0.2}, {0, 0.1}, {0, 0}, {0.2, 0}, {0.5, 0}}};
  for (const double closing_m : {0.005, 0.01, 0.02, 0.04, 0.06}) {
    for (const auto& [stop_s, overlap_s] : stops_and_overlaps_s) {
      unsigned found = 0;
      for (unsigned seed = 0; seed < kDrinks; ++seed)
        found += finds_grasp(EverydayTasks(seed).drink({closing_m, stop_s, overlap_s})) ? 1 : 0;
      EXPECT_GE(found, 0.97 * kDrinks) << closing_m << ", " << stop_s << ", " << overlap_s;
    }
  }
}

TEST(EverydayTasks, ACombTakesNoObject) {
  std::ptrdiff_t invented = 0;
  for (unsigned seed = 0; seed < kTrials; ++seed)
    invented += count_grasps(EverydayTasks(seed).comb().motion());
  EXPECT_EQ(invented, 0);
}

TEST(EverydayTasks, ATouchTakesNoObject) {
  std::ptrdiff_t invented = 0;
  for (const bool returns : {true, false}) {
    for (unsigned seed = 0; seed < kTrials; ++seed)
      invented += count_grasps(EverydayTasks(seed).touch(returns).motion());
  }
  EXPECT_EQ(invented, 0);
}

TEST(EverydayTasks, AStatedTaskDecidesWhereTheHandDoesNot) {
  unsigned taken = 0, touched = 0;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    const HumanMotion motion = EverydayTasks(seed).touch(true).motion();
    for (const Movement& movement : segment(motion, {}, {}, "drink"))
      taken += last_phase(movement, PhaseKind::grasp) ? 1 : 0;
    for (const Movement& movement : segment(motion, {}, {}, "reach"))
      touched += last_phase(movement, PhaseKind::grasp) ? 1 : 0;
  }
  EXPECT_GT(taken, 0u);
  EXPECT_EQ(touched, 0u);
}

}  // namespace
}  // namespace morphe::segment
