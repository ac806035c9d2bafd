#pragma once

#include <string>
#include <vector>

namespace morphe::study {

/// A line plot over one x axis, drawn as SVG.
struct Plot {
  /// A line of the plot.
  struct Line {
    std::string name;
    std::vector<double> x, y;  ///< NaN interrupts the line
    bool dots = false;         ///< true if a dot is drawn at every point
  };
  /// A shaded interval of x with its name at the top.
  struct Band {
    std::string name;
    double begin = 0, end = 0;
  };
  std::string title, x_label, y_label;
  std::vector<Line> lines;
  std::vector<Band> bands;
  bool same_scale = false;  ///< true if both axes have the same scale
};

/// Draws the plot as an SVG of 900 x 360 pixels; equal plots give equal texts. The axes include all
/// finite points.
std::string svg_of(const Plot& plot);

}  // namespace morphe::study
