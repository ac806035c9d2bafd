#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pipeline/report/svg.hpp"

namespace morphe::report {

struct ChartLine {
  std::string name;
  std::vector<double> x, y;  ///< NaN: nothing there
  std::string_view colour, dash;
};

/// Lines over a common x, from y = 0 up, with ticks at round numbers and their names on top; marks
/// are x at which a thin line stands.
void draw_chart(Svg& svg, const Vec2& corner, const Vec2& size, std::string_view title,
                const std::vector<ChartLine>& lines, const std::vector<double>& marks);

}  // namespace morphe::report
