#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "stages/simulate/results.hpp"

namespace morphe::simulate {
namespace {

/// Number of columns after `plan`, `rollout`, `held` and `failure`.
constexpr std::size_t kCellsOfRollout = 33;

double max_or_zero(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::ranges::max_element(values);
}

/// Returns the text quoted if necessary (RFC 4180).
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// Returns the cells of a task, each after a comma; empty ones for what was not measured.
std::string task_cells(const std::optional<TaskResult>& task) {
  if (!task) return std::string(8, ',');
  const auto cell = [](double value) {
    return std::isfinite(value) ? fmt::format(",{}", value) : std::string(",");
  };
  return fmt::format(",{}", name_of(task->failure)) + cell(task->rise_m) +
         cell(task->palm_offset.distance_m) + cell(task->palm_offset.angle_deg) +
         cell(task->arm_error) + cell(task->carried_error.distance_m) +
         cell(task->place_error.distance_m) + cell(task->tilt_deg);
}

}  // namespace

std::string csv_header() {
  return "plan,rollout,held,failure,friction,torsional_friction_m,mass_kg,arm_error_deg,"
         "hand_error_deg,contact_s,planned_contact_s,pregrasp_displacement_m,"
         "pregrasp_displacement_deg,droop_m,droop_deg,slip_m,drift_m,drift_deg,"
         "in_hand_displacement_m,in_hand_displacement_deg,torque_ratio,contact_source,"
         "required_force_worst_N,required_force_gravity_N,required_force_lift_N,"
         "commanded_force_N,measured_force_N,forecast,load_directions,task,rise_m,palm_offset_m,"
         "palm_offset_deg,carry_arm_error,carried_error_m,place_error_m,tilt_deg\n";
}

std::string csv_rows(const PlanResult& result) {
  std::string rows;
  const std::string plan = csv_cell(result.plan);
  for (int k = 0; k < std::ssize(result.rollouts); ++k) {
    const Rollout& one = result.rollouts[k];
    const HoldResult& lift = one.lift;
    std::string directions;
    for (const HoldResult& hold : one.load_directions)
      directions += fmt::format("{}{}", directions.empty() ? "" : " ", name_of(hold.failure));
    fmt::format_to(
        std::back_inserter(rows),
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},"
        "{}{}\n",
        plan, k, lift.is_held() ? 1 : 0, name_of(lift.failure), one.variation.friction,
        one.variation.torsional_friction_m, one.variation.mass_kg, one.arm_error, one.hand_error,
        one.contact_s, result.planned_contact_s, one.pregrasp_displacement.distance_m,
        one.pregrasp_displacement.angle_deg, lift.droop.distance_m, lift.droop.angle_deg,
        lift.slip_m, lift.drift.distance_m, lift.drift.angle_deg,
        lift.in_hand_displacement.distance_m, lift.in_hand_displacement.angle_deg, one.torque_ratio,
        name_of(result.contact_source), one.required_force_worst_N, one.required_force_gravity_N,
        lift.required_force_N, one.commanded_force_N, max_or_zero(one.measured_force_N),
        name_of(one.forecast(lift)), directions, task_cells(one.task));
  }
  if (result.rollouts.empty()) {
    // An empty cell for each column but plan, rollout, held and failure.
    rows = fmt::format("{},,0,{}{}\n", plan, name_of(result.skip_reason),
                       std::string(kCellsOfRollout, ','));
  }
  return rows;
}

}  // namespace morphe::simulate
