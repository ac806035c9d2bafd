#include "pipeline/study/trade_off_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace morphe::study {
namespace {

constexpr double kPlotWidth_px = 290, kPlotHeight_px = 190, kLegendWidth_px = 80;
/// The figures that are drawn over the palm's.
constexpr std::array kDrawnFigures{kUpperArmFigure, kDurationFigure, kSpeedFigure};

std::string printed(const TradeOffFigure& figure, double value) {
  return std::isnan(value) ? "–"
                           : fmt::format("{:.{}f}", figure.print_scale * value, figure.digits);
}

void add_rows(const Case& condition, const TradeOffPoint& point, StudyResult& result) {
  const auto share = [&](int part) { return part / static_cast<double>(point.movements.size()); };
  result.add(condition, "executable", "1", share(point.executable), std::ssize(point.movements));
  result.add(condition, "repaired", "1", share(point.repaired), std::ssize(point.movements));
  for (int i = 0; i < kTradeOffFigureCount; ++i) {
    const TradeOffFigure& figure = trade_off_figures()[i];
    result.add(condition, figure.metric, figure.unit, point.median(i), point.executable);
  }
}

void add_rows(const std::string& key, const RobotTradeOff& robot, StudyResult& result) {
  const Case condition{{"robot", robot.robot}};
  for (const auto& [recordings, curve] :
       {std::pair("choose", &robot.choose), std::pair("show", &robot.show)})
    for (std::size_t k = 0; k < curve->size(); ++k) {
      const TradeOffPoint& point = (*curve)[k];
      const Case at_value = case_with(case_with(condition, "recordings", recordings), "weight",
                                      fmt::format("{}={}", key, point.value));
      add_rows(at_value, point, result);
      result.add(at_value, "loss against the least value, median", "1", loss_of(*curve, k),
                 point.executable);
    }
  result.add(case_with(condition, "weight", key), "knee", "1", robot.knee(),
             std::ssize(robot.choose));
}

double common_knee_of(const std::vector<RobotTradeOff>& robots) {
  std::vector<double> knees;
  for (const RobotTradeOff& robot : robots) knees.push_back(robot.knee());
  return common_knee(knees);
}

std::string table_header(const std::string& key) {
  std::string header = fmt::format("| robot | `{}` | executable | repaired |", key);
  std::string rule = "|---|---|---|---|";
  for (const TradeOffFigure& figure : trade_off_figures()) {
    header += fmt::format(" {} |", figure.name);
    rule += "---|";
  }
  return header + " loss |\n" + rule + "---|\n";
}

/// Returns the rows of a curve; the value of the knee is bold.
std::string table_rows(const RobotTradeOff& robot, const TradeOffCurve& curve) {
  std::string text;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const TradeOffPoint& point = curve[k];
    const char* mark = point.value == robot.knee() ? "**" : "";
    text +=
        fmt::format("| {} | {}{}{} | {} of {} | {} |", k == 0 ? robot.robot : "", mark, point.value,
                    mark, point.executable, point.movements.size(), point.repaired);
    for (int i = 0; i < kTradeOffFigureCount; ++i)
      text += fmt::format(" {} |", printed(trade_off_figures()[i], point.median(i)));
    text += fmt::format(" {:.1f} |\n", loss_of(curve, k));
  }
  return text;
}

std::string table_of(const std::string& key, const std::vector<RobotTradeOff>& robots) {
  std::string choose, show;
  for (const RobotTradeOff& robot : robots) {
    choose += table_rows(robot, robot.choose);
    show += table_rows(robot, robot.show);
  }
  std::string text = fmt::format(
      "Medians over the executable movements; loss: median against the least value, in units of 3 "
      "degrees, 5 % of the time and 0.05 of the correlation. Bold: the knee of the robot. Knee of "
      "all robots: {}.\n"
      "\nRecordings that choose the knee:\n\n{}{}",
      common_knee_of(robots), table_header(key), choose);
  if (!show.empty()) text += fmt::format("\nOther recordings:\n\n{}{}", table_header(key), show);
  return text;
}

Plot::Line line_of(const char* name, const TradeOffCurve& curve, int figure) {
  const TradeOffFigure &palm = trade_off_figures()[kPalmFigure],
                       &other = trade_off_figures()[figure];
  Plot::Line line{name, {}, {}, true, {}};
  for (const TradeOffPoint& point : curve) {
    line.x.push_back(palm.print_scale * point.median(kPalmFigure));
    line.y.push_back(other.print_scale * point.median(figure));
    line.labels.push_back(fmt::format("{}", point.value));
  }
  return line;
}

Plot plot_of(const RobotTradeOff& robot, int figure) {
  Plot plot;
  plot.title = figure == kDrawnFigures.front() ? robot.robot : "";
  plot.x_label = trade_off_figures()[kPalmFigure].name;
  plot.y_label = trade_off_figures()[figure].name;
  plot.width_px = kPlotWidth_px;
  plot.height_px = kPlotHeight_px;
  plot.legend_width_px = 0;
  plot.lines.push_back(line_of("choose", robot.choose, figure));
  if (!robot.show.empty()) plot.lines.push_back(line_of("show", robot.show, figure));
  if (figure == kDrawnFigures.back()) {
    plot.legend_width_px = kLegendWidth_px;
    plot.width_px += kLegendWidth_px;
  }
  return plot;
}

PlotGrid grid_of(const std::string& key, const std::vector<RobotTradeOff>& robots) {
  PlotGrid grid;
  grid.columns = kDrawnFigures.size();
  grid.caption = fmt::format("Medians with the values of {} at the dots; knee of all robots: {}",
                             key, common_knee_of(robots));
  for (const RobotTradeOff& robot : robots)
    for (const int figure : kDrawnFigures) grid.plots.push_back(plot_of(robot, figure));
  return grid;
}

}  // namespace

std::string point_sentence(const TradeOffPoint& point) {
  std::string text = fmt::format("{} of {} executable ({} repaired)", point.executable,
                                 point.movements.size(), point.repaired);
  for (int i = 0; i < kTradeOffFigureCount; ++i)
    text += fmt::format(", {} {}", trade_off_figures()[i].name,
                        printed(trade_off_figures()[i], point.median(i)));
  return text;
}

void add_trade_off(const std::string& key, const std::vector<RobotTradeOff>& robots,
                   StudyResult& result) {
  for (const RobotTradeOff& robot : robots) add_rows(key, robot, result);
  result.add({{"robot", "all"}, {"weight", key}}, "knee", "1", common_knee_of(robots),
             std::ssize(robots));
  std::string name = key.substr(key.rfind('.') + 1);
  result.tables.emplace_back(name, table_of(key, robots));
  result.grids.emplace_back(std::move(name), grid_of(key, robots));
}

}  // namespace morphe::study
