#include "pipeline/report/svg_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace morphe::report {
namespace {

constexpr double kFontSize_px = 11;

struct Axis {
  double low = 0, high = 1, step = 0.5;
};

/// Returns the least 1, 2 or 5 times a power of ten that is at least span / steps; both positive.
double round_step(double span, int steps) {
  const double min_step = span / steps, power = std::pow(10, std::floor(std::log10(min_step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= min_step) return factor * power;
  }
  return 10 * power;
}

Axis axis_of(double low, double high, int steps) {
  if (!(high > low)) high = low + 1;
  return {low, high, round_step(high - low, steps)};
}

struct Range {
  double low = kInfinity, high = -kInfinity;
  void add(double x) {
    if (!std::isfinite(x)) return;
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

}  // namespace

void draw_chart(Svg& svg, const Vec2& corner, const Vec2& size, std::string_view title,
                const std::vector<ChartLine>& lines, const std::vector<double>& marks) {
  Range x_range, y_range;
  y_range.add(0);
  for (const ChartLine& line : lines) {
    for (const double x : line.x) x_range.add(x);
    for (const double y : line.y) y_range.add(y);
  }
  if (x_range.low > x_range.high) x_range = {0, 1};
  const Axis x_axis = axis_of(x_range.low, x_range.high, 8);
  const Axis y_axis = axis_of(0, 1.06 * y_range.high, 4);
  const Vec2 low = corner + Vec2(38, 22), high = corner + size - Vec2(8, 30);
  const auto pixel = [&](double x, double y) {
    const double x_share = (x - x_axis.low) / (x_axis.high - x_axis.low);
    const double y_share = (y - y_axis.low) / (y_axis.high - y_axis.low);
    return Vec2(low.x() + x_share * (high.x() - low.x()),
                high.y() - y_share * (high.y() - low.y()));
  };
  svg.text(corner + Vec2(4, 12), kFontSize_px + 1, "start", title);
  for (int k = 0; k * y_axis.step <= y_axis.high; ++k) {
    const double y = k * y_axis.step;
    const Vec2 left = pixel(x_axis.low, y);
    svg.line(left, pixel(x_axis.high, y), 0.5, k == 0 ? Colours::kInk : Colours::kObject);
    svg.text(left + Vec2(-5, 4), kFontSize_px, "end", fmt::format("{:.6g}", y));
  }
  const double first = std::ceil(x_axis.low / x_axis.step - 1e-9);
  for (int k = 0; (first + k) * x_axis.step <= x_axis.high + 1e-9; ++k) {
    const double x = (first + k) * x_axis.step;
    const Vec2 tick = pixel(x, 0);
    svg.line(tick, tick + Vec2(0, 4), 0.5, Colours::kInk);
    svg.text(tick + Vec2(0, 16), kFontSize_px, "middle", fmt::format("{:.6g}", x));
  }
  svg.text({high.x(), high.y() + 28}, kFontSize_px, "end", "time [s]");
  for (const double x : marks) svg.line(pixel(x, 0), pixel(x, y_axis.high), 0.6, Colours::kFaint);
  double legend_x = low.x() + 8;
  for (const ChartLine& line : lines) {
    std::vector<Vec2> points;
    for (int i = 0; i < std::ssize(line.x); ++i) points.push_back(pixel(line.x[i], line.y[i]));
    svg.polyline(points, 1.5, line.colour, line.dash);
    const Vec2 legend(legend_x, high.y() + 25);
    svg.polyline({legend, legend + Vec2(20, 0)}, 1.5, line.colour, line.dash);
    svg.text(legend + Vec2(24, 4), kFontSize_px, "start", line.name);
    legend_x += 44 + 6.2 * static_cast<double>(line.name.size());
  }
}

}  // namespace morphe::report
