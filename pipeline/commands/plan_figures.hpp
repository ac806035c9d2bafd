#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::commands {

/// A figure of a plan, as shown in tables and comparisons.
struct PlanFigure {
  /// Key for --sort and for JSON, in which the value is in SI units.
  std::string_view key;
  /// Printed name and unit, "" for a dimensionless number.
  std::string_view name, unit;
  /// Factor from the value to the printed number.
  double print_scale;
  /// The number of printed decimals.
  int digits;
  /// 1 if larger values are worse, -1 if smaller values are worse.
  int worse_sign;
  /// Computes the value, NaN if it does not apply.
  double (*compute)(const RobotModel&, const Plan&);
  /// True if it compares with the shoulder and elbow of the person.
  bool uses_human_arm = false;
};

/// The number of figures.
inline constexpr std::size_t kPlanFigureCount = 12;
/// Returns the figures mapped, out_of_reach, step, grasp, tips_mean, tips, humanlikeness,
/// upper_arm, palm, clearance, tempo and duration.
const std::array<PlanFigure, kPlanFigureCount>& plan_figures();

/// The values of all figures of a plan.
using FigureValues = std::array<double, kPlanFigureCount>;
/// Computes the values of all figures of a plan.
FigureValues figures_of(const RobotModel& robot, const Plan& plan);

/// Returns the median of the values that are not NaN, which for an even number is the mean of the
/// two middle ones; NaN if there are no such values.
double median_of(std::vector<double> values);

/// Formats a figure in its printed unit, "-" for NaN, with "~" before a figure of an estimated arm.
std::string format_figure(const PlanFigure& figure, double value, bool arm_estimated = false);

}  // namespace morphe::commands
