#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::commands {

/// A figure of a plan, as tables and comparisons show it.
struct PlanFigure {
  std::string_view key;         ///< of --sort and in JSON, where it stands in SI units
  std::string_view name, unit;  ///< as printed; a number without a unit: ""
  double per_si;                ///< what is printed = per_si * value
  int digits;
  int worse;                                     ///< 1: the larger, the worse; -1: the smaller
  double (*of)(const RobotTable&, const Plan&);  ///< NaN: does not apply
  bool of_the_arm = false;                       ///< compares with the person's shoulder and elbow
};

inline constexpr std::size_t kPlanFigures = 12;
/// mapped, out_of_reach, step, grasp, tips_mean, tips, humanlikeness, upper_arm, palm, clearance,
/// tempo, duration.
const std::array<PlanFigure, kPlanFigures>& plan_figures();

using FigureValues = std::array<double, kPlanFigures>;
FigureValues figures_of(const RobotTable& robot, const Plan& plan);

/// The middle of those that are numbers, of an even count the mean of the two; NaN if there is
/// none.
double median_of(std::vector<double> values);

/// "-" for NaN; in the unit of print. "~" before a figure of an arm that was estimated.
std::string printed(const PlanFigure& figure, double value, bool arm_estimated = false);

}  // namespace morphe::commands
