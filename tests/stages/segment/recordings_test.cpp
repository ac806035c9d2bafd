// Fingertip phases of datasets/ue-adl against those measured by hand in its README: frames, 1-based
// at 100 Hz, where the speed of the index marker passes 5 % of its peak.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "stages/segment/segment.hpp"

namespace morphe {
namespace {

/// Index and thumb markers of a Vicon CSV as fingertips, no wrist: what this test needs, no more.
HumanMotion fingertips(const std::string& trial) {
  std::ifstream file(MORPHE_SOURCE_DIR "/datasets/ue-adl/" + trial + ".csv");
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.find_first_not_of("\r,") == std::string::npos) continue;
    std::vector<std::string>& cells = lines.emplace_back();
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  }
  HumanMotion motion;
  if (lines.size() < 6) return motion;
  std::map<std::string, std::size_t> column;
  for (std::size_t i = 0; i < lines[2].size(); ++i) {
    column[lines[2][i].substr(lines[2][i].find(':') + 1)] = i;
  }
  motion.tip = Table<Vec3>(lines.size() - 5, kFingers, unseen_point());
  for (std::size_t i = 5; i < lines.size(); ++i) {
    motion.time.push_back(0.01 * static_cast<double>(i - 5));
    const auto point = [&](const char* name) -> Vec3 {
      const auto at = [&](std::size_t k) {
        return std::stod(lines[i].at(column.at(name) + k)) / 1000;
      };
      return Vec3(at(0), at(1), at(2));
    };
    motion.tip(i - 5, 0) = point("RTHUM");
    motion.tip(i - 5, 1) = point("RFTP");
  }
  return motion;
}

struct Expected {
  const char* phase;
  double begin, end;  ///< frames
  double begin_within = 3;
};
struct Trial {
  const char* name;
  std::vector<Expected> phases;
  friend std::ostream& operator<<(std::ostream& out, const Trial& t) { return out << t.name; }
};

class Recordings : public testing::TestWithParam<Trial> {};

TEST_P(Recordings, BoundariesAreThoseMeasuredByHand) {
  const HumanMotion motion = fingertips(GetParam().name);
  ASSERT_FALSE(motion.time.empty());
  const auto movements = segment(motion, {});
  ASSERT_EQ(movements.size(), 1u);
  std::vector<Phase> moving;
  bool grasp = false;
  for (const Phase& phase : movements[0].phases) {
    grasp |= phase.name == "grasp";
    if (phase.name == "reach" || phase.name == "transport" || phase.name == "return") {
      moving.push_back(phase);
    }
  }
  EXPECT_EQ(grasp, GetParam().phases.size() > 1);
  ASSERT_EQ(moving.size(), GetParam().phases.size());
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const Expected& expected = GetParam().phases[k];
    EXPECT_EQ(moving[k].name, expected.phase);
    EXPECT_NEAR(moving[k].begin_s * 100 + 1, expected.begin, expected.begin_within)
        << expected.phase << k;
    EXPECT_NEAR(moving[k].end_s * 100 + 1, expected.end, 3) << expected.phase << k;
  }
}

// All within 3 frames but one: before the return of ADL006DR2 the speed stays between 0.048 and
// 0.057 m/s from frame 385 to 399 (5 % of the peak is 0.056), so that onset is less well defined.
INSTANTIATE_TEST_SUITE_P(UeAdl, Recordings,
                         testing::Values(Trial{"ADL001DR2",
                                               {{"reach", 67, 173},
                                                {"transport", 206, 399},
                                                {"transport", 413, 603},
                                                {"return", 628, 725}}},
                                         Trial{"ADL004DR2",
                                               {{"reach", 40, 130},
                                                {"transport", 148, 243},
                                                {"transport", 290, 390},
                                                {"return", 408, 471}}},
                                         Trial{"ADL006DR2",
                                               {{"reach", 40, 123},
                                                {"transport", 124, 272},
                                                {"transport", 279, 384},
                                                {"return", 402, 476, 5}}},
                                         Trial{"ADL001FR1", {{"reach", 64, 172}}},
                                         Trial{"ADL001AR1", {{"reach", 87, 185}}}),
                         [](const auto& trial) { return std::string(trial.param.name); });

}  // namespace
}  // namespace morphe
