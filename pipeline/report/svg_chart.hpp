#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/report/svg.hpp"

namespace morphe::report {

/// A line of a chart.
struct ChartLine {
  /// The name of the line.
  std::string name;
  /// Coordinates; NaN leaves a gap.
  std::vector<double> x, y;
  /// The colour and the dash pattern.
  std::string_view colour, dash;
};

/// Draws lines over a common x, from y = 0 up, with ticks at round numbers and the names of the
/// lines on top. `marks` are x values at which a thin line is drawn.
void draw_chart(Svg& svg, const Vec2& corner, const Vec2& size, std::string_view title,
                const std::vector<ChartLine>& lines, const std::vector<double>& marks);

}  // namespace morphe::report
