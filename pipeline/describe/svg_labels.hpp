#pragma once

#include <string>
#include <vector>

namespace morphe::describe {

/// A text that belongs to a point of a drawing [pixels].
struct SvgLabel {
  double x = 0, y = 0;
  std::string text, colour;
};

/// A panel of a drawing, with a column for labels on either side [pixels].
struct SvgPanel {
  double left = 0, top = 0, width = 0, height = 0;
};

inline constexpr double kLabelFontSize_px = 10;
inline constexpr double kLabelSpacing_px = 12.5;  ///< of lines of that size, so that none overlap
inline constexpr double kLabelColumn_px = 130;    ///< room for about 22 letters

/// Returns the height of a panel in which all labels have room.
double height_for_labels(const std::vector<SvgLabel>& labels, const SvgPanel& panel);

/// Writes the labels below each other into the columns of a panel, each in that of its half and as
/// near to the height of its point as the others allow, with a line to the point.
std::string labels_svg(const std::vector<SvgLabel>& labels, const SvgPanel& panel);

}  // namespace morphe::describe
