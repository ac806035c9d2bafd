#include "pipeline/planning/pipeline_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/motion/input_error.hpp"

namespace morphe::planning {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// Configs in a folder of their own, beside the shipped robot.
class PipelineConfigFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() /
             ("morphe_planning_config_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return folder / name;
  }
  std::string error(const std::filesystem::path& file,
                    const std::vector<std::string>& settings = {}) const {
    try {
      load_config(file, settings);
    } catch (const InputError& wrong) {
      return wrong.what();
    }
    return "no error";
  }

  const std::string robot =
      "robot: {file: " MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml}\n";
  std::filesystem::path folder;
};

TEST_F(PipelineConfigFiles, AConfigExtendsAnotherAndSettingsReplaceBoth) {
  write("base.yaml", robot + "seed: 4\nmap: {starts: 7, tip_position: 10}\n");
  const auto file = write("c.yaml", "extends: base.yaml\nmap: {starts: 9}\n");
  const LoadedConfig loaded = load_config(file, {"map.candidates=2", "retime.mode=fastest"});
  EXPECT_EQ(loaded.options.seed, 4u);
  EXPECT_EQ(loaded.options.map.starts, 9);
  EXPECT_EQ(loaded.options.map.objective.get<humanlike::TipPosition>().weight, 10);
  EXPECT_EQ(loaded.options.map.candidates, 2);
  EXPECT_EQ(loaded.options.retime.mode, retime::RetimeMode::fastest);
  EXPECT_EQ(loaded.robot.joints(), 22u);
  EXPECT_EQ(loaded.robot.arm_joints.size(), 7u) << "what follows from the table is there";
}

TEST_F(PipelineConfigFiles, TheEffectiveConfigIsAConfigThatGivesItselfBack) {
  const auto file = write("c.yaml", robot + "map: {humanlike_hull: 0.5}\n");
  const LoadedConfig loaded = load_config(file);
  const LoadedConfig again =
      load_config(write("effective.yaml", loaded.effective),
                  {"robot.file=" MORPHE_SOURCE_DIR "/configs/robots/pa10_dlr_hit2.yaml"});
  EXPECT_EQ(again.effective, loaded.effective);
  EXPECT_EQ(again.options.map.objective.get<humanlike::HullVolume>().weight, 0.5);
  EXPECT_THAT(loaded.effective, HasSubstr("humanlike_triangle: 0"));
}

TEST_F(PipelineConfigFiles, MistakesNameFileLineAndKey) {
  const auto wrong = [&](const std::string& text) { return error(write("c.yaml", robot + text)); };
  EXPECT_THAT(wrong("map: {start: 9}\n"),
              EndsWith("c.yaml:2: map.start: unknown key; did you mean 'starts'?"));
  EXPECT_THAT(wrong("map:\n  natural: []\n"),
              EndsWith("c.yaml:3: map.natural: unknown key; it is now called 'natural_posture'"));
  EXPECT_THAT(wrong("map:\n  mode: human\n"), HasSubstr("c.yaml:3: map.mode: must be humanlike, "));
  EXPECT_THAT(wrong("map: {tip_position: -1}\n"),
              EndsWith("map.tip_position: must be at least 0 and at most 1e+09, not -1"));
  EXPECT_THAT(
      wrong("map:\n  natural_posture:\n    - {joint: nose}\n"),
      HasSubstr("c.yaml:4: map.natural_posture[0].joint: robot pa10_dlr_hit2 has no actuated joint "
                "'nose'"));
  EXPECT_THAT(wrong("approach:\n  home:\n    - {joint: S1, value: 400 deg}\n"),
              HasSubstr("is beyond the joint's limits"));
  EXPECT_THAT(error(write("c.yaml", "seed: 1\n")), HasSubstr("robot: is missing"));
  EXPECT_THAT(error(write("c.yaml", robot), {"map"}), HasSubstr("must have the form a.b=value"));
}

TEST_F(PipelineConfigFiles, ExtendingInACircleIsSeen) {
  write("a.yaml", "extends: b.yaml\n");
  write("b.yaml", "extends: a.yaml\n");
  EXPECT_THAT(error(folder / "a.yaml"), HasSubstr("names a config that itself extends this one"));
}

}  // namespace
}  // namespace morphe::planning
