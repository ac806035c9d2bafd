#pragma once

#include <string>
#include <vector>

namespace morphe::study {

/// A line plot over one x axis, drawn as SVG.
struct Plot {
  /// A line of the plot.
  struct Line {
    std::string name;
    std::vector<double> x, y;              ///< NaN interrupts the line
    bool dots = false;                     ///< true if a dot is drawn at every point
    std::vector<std::string> labels = {};  ///< beside the points, if not empty
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
  double width_px = 900, height_px = 360;
  double legend_width_px = 180;  ///< width at the right for the names of the lines, 0: no names
};

/// Draws the plot as an SVG; equal plots give equal texts. The axes include all finite points.
std::string svg_of(const Plot& plot);

/// Draws plots in rows of `columns`, each as in svg_of(), below a caption.
struct PlotGrid {
  std::string caption;
  std::vector<Plot> plots;
  std::size_t columns = 1;
};
std::string svg_of(const PlotGrid& grid);

}  // namespace morphe::study
