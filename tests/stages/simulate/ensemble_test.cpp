#include "stages/simulate/ensemble.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "stages/simulate/results.hpp"
#include "tests/stages/simulate/gripper.hpp"

namespace morphe::simulate {
namespace {

TEST(Ensemble, VariesWithinItsBoundsFromThePlansName) {
  const Plan plan = cup_plan();
  const SimulateOptions options;
  const PreparedPlan ready = prepare(gripper(), plan, options).plan;
  const Variation first = variation_of(ready, options, "cup/000", 0);
  EXPECT_EQ(first.friction, 0.8);
  EXPECT_EQ(first.mass_kg, 0.3);
  EXPECT_TRUE(first.base_from_target.isApprox(ready.base_from_target));
  std::set<double> masses;
  double widest = 0;
  for (int k = 1; k < 200; ++k) {
    const Variation one = variation_of(ready, options, "cup/000", k);
    EXPECT_GE(one.friction, 0.64);
    EXPECT_LE(one.friction, 0.96);
    EXPECT_NEAR(one.torsional_friction_m / one.friction, 0.002 / 0.8, 1e-12);
    EXPECT_GE(one.mass_kg, 0.24);
    EXPECT_LE(one.mass_kg, 0.36);
    const Vec3 shift = one.base_from_target.translation() - ready.base_from_target.translation();
    EXPECT_NEAR(shift.z(), 0, 1e-12);  // it stands
    EXPECT_LE(shift.cwiseAbs().maxCoeff(), 0.002);
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(one.base_from_target.linear() *
                                                 ready.base_from_target.linear().transpose()));
    EXPECT_LE(turn.angle(), 2 * kRadPerDegree + 1e-12);
    EXPECT_NEAR(std::abs(turn.axis().z()), 1, 1e-6);
    masses.insert(one.mass_kg);
    widest = std::max(widest, shift.cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(masses.size(), 199U);
  EXPECT_GT(widest, 0.0019);
  EXPECT_EQ(variation_of(ready, options, "cup/000", 3).mass_kg,
            variation_of(ready, options, "cup/000", 3).mass_kg);
  EXPECT_NE(variation_of(ready, options, "cup/000", 3).mass_kg,
            variation_of(ready, options, "cup/001", 3).mass_kg);
}

TEST(Ensemble, SpreadsOverARangeWhereOneIsNamed) {
  const Plan plan = cup_plan();
  SimulateOptions options;
  options.friction_range = Range{0.1, 1.2};
  options.mass_range = Range{0.05, 3};
  const PreparedPlan ready = prepare(gripper(), plan, options).plan;
  EXPECT_EQ(variation_of(ready, options, "cup/000", 0).friction, 0.8);
  int below = 0;  // the middle of the logarithms
  for (int k = 1; k <= 400; ++k) {
    const Variation one = variation_of(ready, options, "cup/000", k);
    EXPECT_TRUE(one.friction >= 0.1 && one.friction <= 1.2);
    EXPECT_TRUE(one.mass_kg >= 0.05 && one.mass_kg <= 3);
    EXPECT_NEAR(one.torsional_friction_m / one.friction, 0.002 / 0.8, 1e-12);
    below += one.mass_kg < std::sqrt(0.05 * 3) ? 1 : 0;
  }
  EXPECT_NEAR(below, 200, 40);
  options.mass_range = Range{3, 0.05};
  EXPECT_NE(validation_error(options), "");
}

PlanResult some_result() {
  PlanResult result;
  result.plan = "a, \"b\"/000";
  result.plan_sha256 = "abc";
  result.notes = {"a note"};
  result.finger_forces = {{1, Vec3(0.1, 0.2, 1.0 / 3), Vec3(0, 0, -1), 7.25, Vec3(1, 2, 0)}};
  result.tips = {"thumb_tip"};
  result.force_scale = 0.875;
  result.planned_contact_s = 1.5;
  Rollout rollout;
  rollout.variation = {0.1, 0.2, 0.3,
                       make_pose(Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())))};
  rollout.arm_error = 0.1;
  rollout.hand_error = 1.0 / 7;
  rollout.contact_s = kUnknown;
  rollout.pregrasp_displacement = {0.001, 2};
  rollout.torque_ratio = 0.5;
  rollout.commanded_force_N = 5;
  rollout.required_force_worst_N = kInfinity;
  rollout.required_force_gravity_N = 6;
  rollout.measured_force_N = {4, 5.5};
  rollout.lift = {Failure::pivot, "words", {1, 2}, {3, 4}, {5, 6}, 7, 1.0 / 3};
  rollout.load_directions = {{Failure::none, "", {1, 2}, {3, 4}, {5, 6}, 7, kInfinity}};
  Rollout carried = rollout;
  carried.task = {Failure::tilted, 0.1, {1, 2}, 1.0 / 3, {3, 4}, kNotMeasured, 12.5, kNotMeasured};
  result.rollouts = {rollout, carried};
  return result;
}

TEST(Results, AFileGivesEveryNumberBack) {
  const SimulateOptions options;
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "morphe_simulate_results_test.json";
  const std::string text = result_json(some_result(), options, "key");
  std::ofstream(file) << text;
  const std::optional<PlanResult> read = read_result(file, "key");
  ASSERT_TRUE(read);
  EXPECT_EQ(result_json(*read, options, "key"), text);
  EXPECT_EQ(csv_rows(*read), csv_rows(some_result()));
  EXPECT_FALSE(read_result(file, "another key"));
  std::ofstream(file) << text.substr(0, text.size() / 2);
  EXPECT_FALSE(read_result(file, "key"));
  std::filesystem::remove(file);
  EXPECT_FALSE(read_result(file, "key"));
}

/// Cells of a line of CSV, quotes and all.
std::size_t cells_in(const std::string& line) {
  bool quoted = false;
  std::size_t cells = 1;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++cells;
  }
  return cells;
}

TEST(Results, EveryLineOfTheTableHasACellAColumn) {
  const std::size_t columns = cells_in(csv_header());
  PlanResult result = some_result();
  const std::string rows = csv_rows(result);
  EXPECT_EQ(std::ranges::count(rows, '\n'), 2);
  EXPECT_EQ(cells_in(rows.substr(0, rows.find('\n'))), columns);
  EXPECT_EQ(rows.substr(0, rows.find("/000")), "\"a, \"\"b\"\"");
  result.rollouts.clear();
  result.skip_reason = SkipReason::no_grasp;
  EXPECT_EQ(cells_in(csv_rows(result)), columns);
}

TEST(Results, AKeyKnowsWhatTheResultDependsOn) {
  const Plan plan = cup_plan();
  std::set<std::string> keys;
  SimulateOptions options;
  keys.insert(result_key(gripper(), plan, options, "program"));
  keys.insert(result_key(gripper(), plan, options, "another program"));
  options.friction = 0.4;
  keys.insert(result_key(gripper(), plan, options, "program"));
  Plan other = plan;
  other.trajectory.position(3, 1) += 1e-12;
  keys.insert(result_key(gripper(), other, options, "program"));
  EXPECT_EQ(keys.size(), 4U);
}

}  // namespace
}  // namespace morphe::simulate
