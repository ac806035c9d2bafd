#pragma once

#include <filesystem>
#include <string>

#include "core/motion/demonstration.hpp"
#include "core/motion/input_error.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::store {

/// Every field differs from its default, every number from every other, and some are NaN.
Demonstration full_demonstration(const std::string& name);
RobotModel small_robot();
PlanFileHeader plan_header();
Plan full_plan(const std::string& demonstration, int movement);
/// As it leaves a stage that gave up early: nothing but a reason.
Plan infeasible_plan(const std::string& demonstration, int movement);

/// A file name of its own for the running test, in a folder that is there and holds no such file.
std::filesystem::path fresh_file(const std::string& name);
std::string bytes_of(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);
/// /usr/bin/python3 tests/core/store/<script> with these arguments; its exit code.
int run_python(const std::string& script, const std::string& arguments);
/// The message of the InputError that a call throws, "" if it throws none.
template <class Call>
std::string input_error(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace morphe::store
