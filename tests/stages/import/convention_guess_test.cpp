#include <gtest/gtest.h>

#include "stages/import/guess/convention_guess.hpp"
#include "stages/import/import.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {
namespace {

const std::string kSource = MORPHE_SOURCE_DIR;
constexpr const char* kAxes[] = {"x", "y", "z", "-x", "-y", "-z"};

/// The five shipped trials at a table, in the world.
std::vector<Demonstration> table_trials() {
  ImportRequest request;
  request.paths = {kSource + "/datasets/ue-adl/recordings.yaml"};
  std::vector<Demonstration> trials;
  import_recordings(request, [&](Demonstration&& d) { trials.push_back(std::move(d)); });
  return trials;
}

/// All right-handed choices of axes.
std::vector<std::string> all_axes() {
  std::vector<std::string> all;
  for (const char* right : kAxes) {
    for (const char* forward : kAxes) {
      for (const char* up : kAxes) {
        const std::string axes = std::string(right) + " " + forward + " " + up;
        try {
          world_from_recorded(axes, "");
          all.push_back(axes);
        } catch (const InputError&) {
        }
      }
    }
  }
  return all;
}

TEST(BodyGuess, TheAxesOfEveryTrialHoweverItWasTurned) {
  ASSERT_EQ(all_axes().size(), 24u);
  for (const Demonstration& trial : table_trials()) {
    RecordedPoints points = recorded_points(trial.streams, trial.hand);
    const Array2D<Vec3> world = points.position;
    for (const std::string& axes : all_axes()) {
      const Eigen::Matrix3d recorded_from_world = world_from_recorded(axes, "").transpose();
      for (std::size_t i = 0; i < world.values.size(); ++i) {
        points.position.values[i] = recorded_from_world * world.values[i];
      }
      EXPECT_EQ(guess_axes(points).value, axes) << trial.name;
    }
  }
}

/// Of one arm's clusters alone the reach across the body is not told; but then it is not sure.
TEST(BodyGuess, TheAxesOfAnArmAlone) {
  int right = 0;
  for (const Demonstration& trial : table_trials()) {
    RecordedPoints points = recorded_points(trial.streams, trial.hand);
    for (std::string& part : points.parts) {
      if (!part.starts_with("right")) part.clear();
    }
    const Guess guess = guess_axes(points);
    if (guess.value == "x y z") {
      ++right;
    } else {
      EXPECT_EQ(guess.confidence, Confidence::guessed) << trial.name;
    }
  }
  EXPECT_GE(right, 4);
}

TEST(BodyGuess, UnitsFromTheLengthsOfABody) {
  for (const Demonstration& trial : table_trials()) {
    RecordedPoints points = recorded_points(trial.streams, trial.hand);
    const Array2D<Vec3> world = points.position;
    for (const auto& [unit, metres] :
         {std::pair("mm", 0.001), std::pair("cm", 0.01), std::pair("m", 1.0), {"in", 0.0254}}) {
      for (std::size_t i = 0; i < world.values.size(); ++i) {
        points.position.values[i] = world.values[i] / metres;
      }
      EXPECT_EQ(guess_unit(points).value, unit) << trial.name;
    }
  }
}

TEST(BodyGuess, NothingToGoByIsSaid) {
  EXPECT_EQ(guess_axes({}).value, "");
  EXPECT_EQ(guess_unit({}).value, "");
  EXPECT_EQ(guess_rate({}, 1).value, "");
}

}  // namespace
}  // namespace morphe::imports
