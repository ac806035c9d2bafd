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
  std::string_view key;   ///< for --sort and for JSON, in which the value is in SI units
  std::string_view name;  ///< in tables
  std::string_view unit;  ///< in tables, "" for a dimensionless number
  double print_scale;     ///< factor from the value to the printed number
  int digits;             ///< printed decimals
  int worse_sign;         ///< 1 if larger values are worse, -1 if smaller values are worse
  double (*compute)(const RobotModel&, const Plan&);  ///< returns NaN if it does not apply
  bool uses_human_arm = false;  ///< true if it compares with the person's shoulder and elbow
};

/// The number of figures.
inline constexpr int kPlanFigureCount = 15;
/// Returns the figures, in the order in which a run's journal stores them.
const std::array<PlanFigure, kPlanFigureCount>& plan_figures();
/// Returns the index of the figure of a key, kPlanFigureCount if there is none.
int figure_index(std::string_view key);

/// The values of all figures of a plan.
using FigureValues = std::array<double, kPlanFigureCount>;
/// Computes the values of all figures of a plan.
FigureValues figures_of(const RobotModel& robot, const Plan& plan);

/// Returns math::midpoint_median() of the values that are not NaN.
double median_of(std::vector<double> values);

/// Formats a figure in its printed unit, "-" for NaN, with "~" before a figure of an estimated arm.
std::string format_figure(const PlanFigure& figure, double value, bool arm_estimated = false);

}  // namespace morphe::commands
