#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/report/svg.hpp"

namespace morphe::report {

/// A line of a chart.
struct ChartLine {
  std::string name;
  std::vector<double> x, y;  ///< time [s] and value; NaN leaves a gap
  std::string_view colour, dash;
};

/// Draws lines over a common time axis, with y from 0 to the largest value, ticks at round numbers
/// and the names of the lines below. `marks` are times at which a thin vertical line is drawn.
void draw_chart(Svg& svg, const Vec2& corner, const Vec2& size, std::string_view title,
                const std::vector<ChartLine>& lines, const std::vector<double>& marks);

}  // namespace morphe::report
