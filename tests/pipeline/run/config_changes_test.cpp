#include "pipeline/run/config_changes.hpp"

#include <gmock/gmock.h>

namespace morphe::run {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ConfigChanges, NamesEachKeyOnce) {
  const std::string before =
      "seed: 1\nmap:\n  starts: 32\n  natural_posture: []\n  frame_solver: {way: newton}\n";
  EXPECT_THAT(config_changes(before, before), IsEmpty());
  EXPECT_THAT(config_changes(before,
                             "seed: 2\nmap:\n  starts: 32\n  natural_posture:\n    - {joint: a}\n"
                             "  frame_solver: {way: newton, steps: 3}\n"),
              ElementsAre("map.frame_solver.steps none -> 3",
                          "map.natural_posture [] -> [{joint: a}]", "seed 1 -> 2"));
}

}  // namespace
}  // namespace morphe::run
