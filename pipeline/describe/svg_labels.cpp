#include "pipeline/describe/svg_labels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/files/markup.hpp"

namespace morphe::describe {
namespace {

constexpr std::size_t kMaxLetters = 22;

/// Returns the labels of one column, from the top.
std::vector<SvgLabel> column_of(const std::vector<SvgLabel>& labels, const SvgPanel& panel,
                                bool right) {
  std::vector<SvgLabel> column;
  for (const SvgLabel& label : labels)
    if ((label.x > panel.left + panel.width / 2) == right) column.push_back(label);
  std::ranges::stable_sort(column, {}, &SvgLabel::y);
  return column;
}

/// Returns the heights of labels in a column: those of their points, moved apart within the panel.
std::vector<double> heights_of(const std::vector<SvgLabel>& column, const SvgPanel& panel) {
  std::vector<double> heights;
  for (const SvgLabel& label : column)
    heights.push_back(heights.empty() ? std::max(label.y, panel.top + kLabelSpacing_px)
                                      : std::max(label.y, heights.back() + kLabelSpacing_px));
  double limit = panel.top + panel.height - kLabelSpacing_px / 2;
  for (auto height = heights.rbegin(); height != heights.rend(); ++height) {
    *height = std::min(*height, limit);
    limit = *height - kLabelSpacing_px;
  }
  return heights;
}

std::string shortened(const std::string& text) {
  return text.size() <= kMaxLetters ? text : text.substr(0, kMaxLetters - 1) + "…";
}

std::string label_svg(const SvgLabel& label, double x, double y, bool right) {
  return fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"0.4\" "
      "fill=\"none\" opacity=\"0.6\"/>\n<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" "
      "text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
      label.x, label.y, right ? x - 2 : x + 2, y - 3, label.colour, x, y, kLabelFontSize_px,
      right ? "start" : "end", label.colour, files::escape_xml(shortened(label.text)));
}

}  // namespace

double height_for_labels(const std::vector<SvgLabel>& labels, const SvgPanel& panel) {
  const std::size_t lines =
      std::max(column_of(labels, panel, false).size(), column_of(labels, panel, true).size());
  return kLabelSpacing_px * (static_cast<double>(lines) + 1);
}

std::string labels_svg(const std::vector<SvgLabel>& labels, const SvgPanel& panel) {
  std::string svg;
  for (const bool right : {false, true}) {
    const std::vector<SvgLabel> column = column_of(labels, panel, right);
    const std::vector<double> heights = heights_of(column, panel);
    const double x =
        right ? panel.left + panel.width - kLabelColumn_px : panel.left + kLabelColumn_px;
    for (std::size_t k = 0; k < column.size(); ++k)
      svg += label_svg(column[k], x, heights[k], right);
  }
  return svg;
}

}  // namespace morphe::describe
