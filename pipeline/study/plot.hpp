#pragma once

#include <string>
#include <vector>

namespace morphe::study {

/// Lines over one x axis, drawn as SVG.
struct Plot {
  struct Line {
    std::string name;
    std::vector<double> x, y;  ///< a NaN ends a stroke
    bool dots = false;         ///< at every point
  };
  /// A shaded interval of x, named at its top.
  struct Band {
    std::string name;
    double begin = 0, end = 0;
  };
  std::string title, x_label, y_label;
  std::vector<Line> lines;
  std::vector<Band> bands;
  bool same_scale = false;  ///< a metre is as long on both axes
};

/// 900 x 360 pixels, self-contained; axes hold all finite points. The same plot gives the same
/// text.
std::string svg_of(const Plot& plot);

}  // namespace morphe::study
