#include "stages/simulate/servo_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/motion/input_error.hpp"
#include "stages/simulate/servos.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

ServoTable read(const std::string& text) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "morphe_servo_file_test.yaml";
  std::ofstream(file) << text;
  return read_servos(file, gripper_table());
}

std::string refused(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ServoFile, WhatItSaysComesBeforeTheDefaults) {
  SimulateOptions options;
  options.servos = read("index: {stiffness: 20, torque_limit: 0.5}\n");
  const std::vector<Servo> servos = servos_of(gripper(), options);
  EXPECT_EQ(servos[1].stiffness, 10);
  EXPECT_EQ(servos[2].stiffness, 20);
  EXPECT_EQ(servos[2].torque_limit, 0.5);
  EXPECT_EQ(servos[2].armature, servos[1].armature);
  EXPECT_NEAR(servos[2].lead_s, (servos[2].velocity_gain + servos[2].damping) / 20, 1e-12);
  EXPECT_NE(text_of(options), text_of(SimulateOptions()));
}

TEST(ServoFile, EverythingWrongIsNamedWithItsLine) {
  EXPECT_NE(refused("indxe: {stiffness: 20}\n").find("yaml:1: indxe: is not a joint of gripper"),
            std::string::npos)
      << refused("indxe: {stiffness: 20}\n");
  EXPECT_NE(refused("lift: {}\nindex: {stiffness: -1}\n").find("yaml:2: index.stiffness"),
            std::string::npos)
      << refused("lift: {}\nindex: {stiffness: -1}\n");
  EXPECT_NE(refused("index: {stifness: 1}\n").find("stifness"), std::string::npos);
  EXPECT_NE(refused("[1]\n"), "");
}

}  // namespace
}  // namespace morphe::simulate
