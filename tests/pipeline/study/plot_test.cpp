#include "pipeline/study/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morphe::study {
namespace {

Plot small_plot() {
  Plot plot;
  plot.width_px = 300;
  plot.height_px = 200;
  plot.legend_width_px = 0;
  plot.lines.push_back({"line", {0, 1}, {0, 1}, true, {"first", "second"}});
  return plot;
}

TEST(Plot, LabelsStandBesideTheirPointsAndALineWithoutALegendHasNoName) {
  const std::string svg = svg_of(small_plot());
  // The axes go from 0 to 1, from the left margin of 70 to the right one of 20, and from 150 to 40.
  EXPECT_THAT(svg, testing::HasSubstr("<circle cx=\"280.0\" cy=\"40.0\""));
  EXPECT_THAT(svg, testing::HasSubstr("<text x=\"284.0\" y=\"37.0\" font-size=\"9\" "
                                      "fill=\"#1f5fa8\">second</text>"));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr(">line<")));
}

TEST(PlotGrid, PlotsStandSideBySideBelowTheCaption) {
  PlotGrid grid{"a < b", {small_plot(), small_plot(), small_plot()}, 2};
  const std::string svg = svg_of(grid);
  EXPECT_THAT(svg, testing::HasSubstr("width=\"600\" height=\"426\""));
  EXPECT_THAT(svg, testing::HasSubstr(">a &lt; b</text>"));
  for (const char* corner : {"(0 26)", "(300 26)", "(0 226)"})
    EXPECT_THAT(svg, testing::HasSubstr(std::string("translate") + corner));
}

}  // namespace
}  // namespace morphe::study
