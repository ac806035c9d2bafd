#pragma once

#include <string>
#include <vector>

namespace morphe::study {

/// A line plot over one x axis, drawn as SVG.
struct Plot {
  /// A line of the plot.
  struct Line {
    /// The name in the legend.
    std::string name;
    /// Coordinates; NaN interrupts the line.
    std::vector<double> x, y;
    /// True if a dot is drawn at every point.
    bool dots = false;
  };
  /// A shaded interval of x with its name at the top.
  struct Band {
    /// The name of the interval.
    std::string name;
    /// The limits of the interval.
    double begin = 0, end = 0;
  };
  /// The title and the labels of the axes.
  std::string title, x_label, y_label;
  /// The lines, in the order of drawing.
  std::vector<Line> lines;
  /// The shaded intervals.
  std::vector<Band> bands;
  /// True if both axes have the same scale.
  bool same_scale = false;
};

/// Draws the plot as a self-contained SVG of 900 x 360 pixels. The axes include all finite points.
/// Equal plots give equal texts.
std::string svg_of(const Plot& plot);

}  // namespace morphe::study
