#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::study {

/// A figure of the certificate that a weight may improve or worsen.
struct TradeOffFigure {
  const char *metric, *unit;    ///< in the rows of the study, SI
  const char* name;             ///< in tables and plots, with the printed unit
  double print_scale;           ///< factor from the value to the printed number
  int digits;                   ///< printed decimals
  double Certificate::*figure;  ///< the value
  int worse_sign;               ///< 1 if larger values are worse, -1 if smaller ones are
  /// The loss that counts 1: an amount in SI units, or a share of the figure at the least weight.
  /// Infinite: the figure does not decide.
  double unit_loss, unit_share = 0;
};

inline constexpr int kTradeOffFigureCount = 7;
/// Positions of figures that the plots use.
inline constexpr int kPalmFigure = 0, kUpperArmFigure = 1, kDurationFigure = 3, kSpeedFigure = 4;
/// Returns the figures.
const std::array<TradeOffFigure, kTradeOffFigureCount>& trade_off_figures();

/// The values of all figures of a plan, NaN unless it is executable.
using TradeOffValues = std::array<double, kTradeOffFigureCount>;

/// The plans that were made with one value of a weight.
struct TradeOffPoint {
  double value = 0;
  int executable = 0, repaired = 0;
  std::vector<TradeOffValues> movements;

  /// Returns the median of a figure over the executable movements; NaN if there are none.
  double median(int figure) const;
};
/// Returns the counts and figures of plans.
TradeOffPoint point_of(double value, const std::vector<Plan>& plans);

/// The points of a weight, in the order of its ascending values, with the same movements.
using TradeOffCurve = std::vector<TradeOffPoint>;

/// Returns the loss of a point against the first: the median, over the movements that are
/// executable in both, of the sum of the figures' losses in their units; negative if it gains more
/// than it loses. NaN if no movement is executable in both.
double loss_of(const TradeOffCurve& curve, std::size_t point);

/// Returns the position of the knee: the value of the least loss, of those at which at least as
/// many movements are executable as at the first. Beyond it, a larger weight loses more than it
/// gains.
std::size_t knee_of(const TradeOffCurve& curve);

/// Returns the knee of several robots from theirs: the largest value that is not beyond the knee of
/// at least half of them.
double common_knee(const std::vector<double>& knees);

}  // namespace morphe::study
