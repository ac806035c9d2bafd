// Trials of two people who hardly close the hand around the cup, see data/README.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "stages/segment/segment.hpp"

namespace morphe::segment {
namespace {

HumanMotion read_motion(const std::string& name) {
  std::ifstream file(MORPHE_SOURCE_DIR "/tests/stages/segment/data/" + name + ".csv");
  HumanMotion motion;
  std::vector<Vec3> thumb, index;
  std::string line;
  std::getline(file, line);  // header
  while (std::getline(file, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream row(line);
    double time_s = 0;
    row >> time_s;
    motion.time.push_back(time_s);
    for (std::vector<Vec3>* points :
         {&motion.shoulder, &motion.elbow, &motion.wrist, &thumb, &index}) {
      Vec3 point;
      row >> point.x() >> point.y() >> point.z();
      points->push_back(point);
    }
  }
  motion.tip = Array2D<Vec3>(motion.time.size(), kFingerCount, unknown_point());
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    motion.tip(i, kThumb) = thumb[i];
    motion.tip(i, kIndex) = index[i];
  }
  return motion;
}

Movement only_movement(const std::string& name) {
  const std::vector<Movement> movements = segment(read_motion(name), {});
  EXPECT_EQ(movements.size(), 1u) << name;
  return movements.empty() ? Movement{} : movements.front();
}

TEST(EverydayRecordings, TheCupIsTakenAndPutBack) {
  const struct {
    const char* name;
    /// Read from the recordings: the thumb and the index finger have closed, the wrist begins to
    /// rise; it has come down again, the fingers open.
    double closed_s, rises_s, down_s, opens_s;
  } trials[] = {{"ADL007DR1", 1.35, 1.55, 4.75, 5.05},
                {"ADL007DL4", 1.35, 1.60, 4.70, 5.10},
                {"ADL012DR1", 1.65, 1.80, 4.45, 4.75},
                {"ADL012DL2", 1.85, 2.00, 5.05, 5.60}};
  for (const auto& trial : trials) {
    const Movement movement = only_movement(trial.name);
    const Phase* grasp = last_phase(movement, PhaseKind::grasp);
    ASSERT_TRUE(grasp) << trial.name;
    EXPECT_GT(grasp->end_s, trial.closed_s) << trial.name;
    EXPECT_LT(grasp->end_s, trial.rises_s) << trial.name;
    const Phase* home = last_phase(movement, PhaseKind::return_phase);
    ASSERT_TRUE(home) << trial.name;
    EXPECT_GT(home->begin_s, trial.down_s - 0.1) << trial.name;
    EXPECT_LT(home->begin_s, trial.opens_s + 0.1) << trial.name;
  }
}

TEST(EverydayRecordings, ThereIsNoCupInTheHairNorOnASticker) {
  for (const char* name : {"ADL007CR1", "ADL012CL1", "ADL012AR1"})
    EXPECT_FALSE(last_phase(only_movement(name), PhaseKind::grasp)) << name;
}

/// The speed has fallen from its peak to a first minimum as the hand arrives at the head; strokes
/// through the hair follow.
TEST(EverydayRecordings, TheReachOfACombEndsAtTheHead) {
  const struct {
    const char* name;
    double begin_s, arrival_s;
  } trials[] = {{"ADL007CR1", 0.37, 1.26}, {"ADL012CL1", 0.46, 1.28}};
  for (const auto& trial : trials) {
    const Movement comb = only_movement(trial.name);
    ASSERT_FALSE(comb.phases.empty()) << trial.name;
    EXPECT_NEAR(comb.phases.front().begin_s, trial.begin_s, 0.05) << trial.name;
    EXPECT_NEAR(comb.phases.front().end_s, trial.arrival_s, 0.1) << trial.name;
  }
}

}  // namespace
}  // namespace morphe::segment
