// Movements of the shipped recordings against what their README says of them, through import and
// reconstruction as they are used.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stages/import/import.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::segment {
namespace {

std::vector<Movement> movements_of(const std::string& folder, const std::string& name) {
  imports::ImportRequest request;
  request.paths = {MORPHE_SOURCE_DIR "/datasets/" + folder + "/recordings.yaml"};
  std::vector<Movement> movements;
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    if (demonstration.name != name) return;
    movements = segment(reconstruct::reconstruct(demonstration, {}, {}), {}, demonstration.objects);
  });
  return movements;
}

std::vector<Phase> moving_phases(const Movement& movement) {
  std::vector<Phase> moving;
  for (const Phase& phase : movement.phases) {
    if (phase.kind == PhaseKind::reach || phase.kind == PhaseKind::transport ||
        phase.kind == PhaseKind::return_phase) {
      moving.push_back(phase);
    }
  }
  return moving;
}

struct Expected {
  PhaseKind phase;
  double begin, end;  ///< 1-based frames at 100 Hz
};
struct Trial {
  const char* name;
  std::vector<Expected> phases;
};

/// README of ue-adl: where the speed of the index marker passes 5 % of the file's peak (here: of
/// the bout's own).
const std::vector<Trial>& ue_adl() {
  static const std::vector<Trial> trials = {{"ADL001DR2",
                                             {{PhaseKind::reach, 67, 173},
                                              {PhaseKind::transport, 206, 399},
                                              {PhaseKind::transport, 413, 603},
                                              {PhaseKind::return_phase, 628, 725}}},
                                            {"ADL004DR2",
                                             {{PhaseKind::reach, 40, 130},
                                              {PhaseKind::transport, 148, 243},
                                              {PhaseKind::transport, 290, 390},
                                              {PhaseKind::return_phase, 408, 471}}},
                                            {"ADL006DR2",
                                             {{PhaseKind::reach, 40, 123},
                                              {PhaseKind::transport, 124, 272},
                                              {PhaseKind::transport, 279, 384},
                                              {PhaseKind::return_phase, 402, 476}}},
                                            {"ADL001FR1", {{PhaseKind::reach, 64, 172}}},
                                            {"ADL001AR1", {{PhaseKind::reach, 87, 185}}}};
  return trials;
}

TEST(Recordings, EveryReachOfUeAdlIsFoundAndNoneInvented) {
  std::vector<double> reach_errors_s, other_errors_s;
  for (const Trial& trial : ue_adl()) {
    const auto movements = movements_of("ue-adl", trial.name);
    ASSERT_EQ(movements.size(), 1u) << trial.name;
    const std::vector<Phase> moving = moving_phases(movements[0]);
    ASSERT_EQ(moving.size(), trial.phases.size()) << trial.name;
    for (std::size_t k = 0; k < moving.size(); ++k) {
      EXPECT_EQ(moving[k].kind, trial.phases[k].phase) << trial.name;
      auto& errors = k == 0 ? reach_errors_s : other_errors_s;
      errors.push_back(std::abs(moving[k].begin_s - 0.01 * (trial.phases[k].begin - 1)));
      errors.push_back(std::abs(moving[k].end_s - 0.01 * (trial.phases[k].end - 1)));
    }
    const auto grasp = std::count_if(movements[0].phases.begin(), movements[0].phases.end(),
                                     [](const Phase& p) { return p.kind == PhaseKind::grasp; });
    EXPECT_EQ(grasp, moving.size() > 1 ? 1 : 0) << trial.name;
  }
  for (std::vector<double>* errors : {&reach_errors_s, &other_errors_s}) {
    std::sort(errors->begin(), errors->end());
    EXPECT_LE((*errors)[errors->size() / 2], 0.04);
  }
  EXPECT_LE(reach_errors_s.back(), 0.1);
  // ADL006DR2 comes home with two more small peaks after frame 476, at a quarter of its speed.
  EXPECT_LE(other_errors_s[other_errors_s.size() - 2], 0.1);
}

TEST(Recordings, OneReachInEachAdroitDemonstrationAndAReturnAfterTheRelease) {
  const struct {
    const char* name;
    double begin, end;  ///< 0-based rows: from 10 % of the way until the palm is 8 cm away
  } demonstrations[] = {{"door_demo_06", 19, 48},
                        {"door_demo_08", 17, 42},
                        {"door_demo_11", 14, 37},
                        {"door_demo_12", 18, 47},
                        {"door_demo_13", 15, 42}};
  for (const auto& expected : demonstrations) {
    const auto movements = movements_of("adroit-dapg", expected.name);
    ASSERT_EQ(movements.size(), 1u) << expected.name;
    EXPECT_EQ(movements[0].target, "handle");
    const std::vector<Phase> moving = moving_phases(movements[0]);
    EXPECT_LT(moving.front().begin_s, 0.01 * expected.begin) << expected.name;
    EXPECT_GT(moving.front().end_s, 0.01 * expected.end) << expected.name;
    EXPECT_EQ(moving[1].kind, PhaseKind::transport) << expected.name;
    EXPECT_EQ(moving.back().kind, PhaseKind::return_phase) << expected.name;
  }
}

TEST(Recordings, ABoxIsTakenCarriedAndLeft) {
  const auto movements = movements_of("pyomeca", "box");
  ASSERT_EQ(movements.size(), 1u);
  EXPECT_EQ(movements[0].target, "box");
  const std::vector<Phase> moving = moving_phases(movements[0]);
  ASSERT_GE(moving.size(), 3u);
  // By the hand's and the box's speed against 50 mm/s: 35-161, 161-394, 394-573. The hand is slow
  // before the box moves, and after frame 550.
  EXPECT_EQ(moving.front().kind, PhaseKind::reach);
  EXPECT_NEAR(moving.front().begin_s, 0.34, 0.1);
  EXPECT_NEAR(moving.front().end_s, 1.60, 0.2);
  EXPECT_EQ(moving[1].kind, PhaseKind::transport);
  EXPECT_NEAR(moving[1].begin_s, 1.60, 0.1);
  EXPECT_EQ(moving.back().kind, PhaseKind::return_phase);
  EXPECT_NEAR(moving.back().begin_s, 3.93, 0.15);
  EXPECT_NEAR(moving.back().end_s, 5.72, 0.3);
}

}  // namespace
}  // namespace morphe::segment
