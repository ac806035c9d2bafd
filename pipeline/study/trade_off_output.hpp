#pragma once

#include <string>
#include <vector>

#include "pipeline/study/study.hpp"
#include "pipeline/study/trade_off_curve.hpp"

namespace morphe::study {

/// The curves of one robot for one weight.
struct RobotTradeOff {
  std::string robot;
  TradeOffCurve choose, show;  ///< of the recordings that choose the knee, and of others, if any

  double knee() const { return choose[knee_of(choose)].value; }
};

/// Returns the figures of a point as a sentence.
std::string point_sentence(const TradeOffPoint& point);

/// Adds the rows of a weight, its knees, a table in Markdown and a grid of plots with a row for
/// each robot. The files are named after the weight.
void add_trade_off(const std::string& key, const std::vector<RobotTradeOff>& robots,
                   StudyResult& result);

}  // namespace morphe::study
