#include "pipeline/study/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/files/markup.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::study {
namespace {

constexpr int kFontSize_px = 12;
constexpr double kLeftMargin_px = 70, kTopMargin_px = 40, kBottomMargin_px = 50;
constexpr double kMinRightMargin_px = 20;
constexpr double kCaptionHeight_px = 26;
constexpr const char* kColours[] = {"#1f5fa8", "#c0392b", "#2e8b57", "#8e5ea2", "#d68910",
                                    "#17808f", "#7f4f24", "#555555", "#b03a7a", "#6b8e23"};
constexpr const char* kShades[] = {"#dfe9f5", "#f7e3d9"};

/// An axis with about `ticks` round ticks whose distance is 1, 2 or 5 times a power of ten.
struct Axis {
  double low = 0, high = 1, step = 0.2, first = 0;

  Axis(double lo, double hi, bool rounded, double ticks) {
    if (!(lo <= hi)) return;
    const double span = hi > lo ? hi - lo : std::max(1.0, std::abs(hi));
    const double rough = span / ticks, power = std::pow(10, std::floor(std::log10(rough)));
    step = power * (rough / power < 1.5   ? 1
                    : rough / power < 3.5 ? 2
                    : rough / power < 7.5 ? 5
                                          : 10);
    first = (rounded ? std::floor(lo / step) : std::ceil(lo / step)) * step;
    low = rounded ? first : lo;
    high = rounded ? std::ceil(hi / step) * step : hi;
    if (high <= low) high = low + step;
  }
};

struct Range {
  double low = kInfinity, high = -kInfinity;
  void extend(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

void widen(Range& range, double width) {
  const double margin = (width - (range.high - range.low)) / 2;
  range.low -= margin;
  range.high += margin;
}

struct Ranges {
  Range x, y;
};

Ranges ranges_of(const Plot& plot) {
  Ranges ranges;
  for (const Plot::Line& line : plot.lines) {
    for (const double x : line.x) ranges.x.extend(x);
    for (const double y : line.y) ranges.y.extend(y);
  }
  for (const Plot::Band& band : plot.bands) {
    ranges.x.extend(band.begin);
    ranges.x.extend(band.end);
  }
  return ranges;
}

/// The axes of a plot and the pixels of its values.
struct Area {
  double width, height, bottom;  ///< [pixels]
  Axis x_axis, y_axis;

  double px(double x) const {
    return kLeftMargin_px + width * (x - x_axis.low) / (x_axis.high - x_axis.low);
  }
  double py(double y) const {
    return bottom - height * (y - y_axis.low) / (y_axis.high - y_axis.low);
  }
};

/// Returns about how many ticks an axis has room for.
double room_for_ticks(double length_px) { return std::clamp(std::round(length_px / 45), 3.0, 6.0); }

Area area_of(const Plot& plot) {
  const double width =
      plot.width_px - kLeftMargin_px - std::max(plot.legend_width_px, kMinRightMargin_px);
  const double height = plot.height_px - kTopMargin_px - kBottomMargin_px;
  auto [xs, ys] = ranges_of(plot);
  if (plot.same_scale && xs.low <= xs.high && ys.low <= ys.high) {
    const double scale = std::min(width / (xs.high - xs.low), height / (ys.high - ys.low));
    widen(xs, width / scale);
    widen(ys, height / scale);
  }
  return {width, height, plot.height_px - kBottomMargin_px,
          Axis(xs.low, xs.high, !plot.same_scale, room_for_ticks(width)),
          Axis(ys.low, ys.high, !plot.same_scale, room_for_ticks(height))};
}

std::string bands_svg(const Plot& plot, const Area& area) {
  std::string svg;
  for (int i = 0; i < std::ssize(plot.bands); ++i) {
    const Plot::Band& band = plot.bands[i];
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n"
        "<text x=\"{:.1f}\" y=\"{}\" font-size=\"10\" fill=\"#555\">{}</text>\n",
        area.px(band.begin), kTopMargin_px, area.px(band.end) - area.px(band.begin), area.height,
        kShades[i % std::ssize(kShades)], area.px(band.begin) + 2,
        kTopMargin_px + 10 + 11.0 * (i % 3), files::escape_xml(band.name));
  }
  return svg;
}

std::string ticks_svg(const Area& area) {
  const auto ticks = [](const Axis& axis) {
    return static_cast<int>(std::floor((axis.high - axis.first) / axis.step + 1e-9));
  };
  std::string svg;
  for (int k = 0; k <= ticks(area.x_axis); ++k) {
    const double x = area.x_axis.first + k * area.x_axis.step;
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:.6g}</text>\n",
        area.px(x), kTopMargin_px, area.bottom, area.bottom + 16, x);
  }
  for (int k = 0; k <= ticks(area.y_axis); ++k) {
    const double y = area.y_axis.first + k * area.y_axis.step;
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.6g}</text>\n",
        kLeftMargin_px, kLeftMargin_px + area.width, area.py(y), kLeftMargin_px - 6, area.py(y) + 4,
        y);
  }
  return svg;
}

std::string point_svg(const Plot::Line& line, int k, double x, double y, const char* colour) {
  std::string svg;
  if (line.dots)
    svg +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", x, y, colour);
  if (k < std::ssize(line.labels))
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"9\" fill=\"{}\">{}</text>\n",
                       x + 4, y - 3, colour, files::escape_xml(line.labels[k]));
  return svg;
}

std::string line_svg(const Plot::Line& line, const Area& area, const char* colour) {
  std::string path, points;
  bool interrupted = true;
  for (int k = 0; k < std::min(std::ssize(line.x), std::ssize(line.y)); ++k) {
    const bool known = std::isfinite(line.x[k]) && std::isfinite(line.y[k]);
    if (known) {
      const double x = area.px(line.x[k]), y = area.py(line.y[k]);
      path += fmt::format("{}{:.1f} {:.1f}", interrupted ? "M" : "L", x, y);
      points += point_svg(line, k, x, y, colour);
    }
    interrupted = !known;
  }
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n{}", path,
                     colour, points);
}

std::string lines_svg(const Plot& plot, const Area& area) {
  std::string svg;
  for (int i = 0; i < std::ssize(plot.lines); ++i) {
    const char* colour = kColours[i % std::ssize(kColours)];
    svg += line_svg(plot.lines[i], area, colour);
    if (plot.legend_width_px > 0)
      svg += fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n",
                         kLeftMargin_px + area.width + 10, kTopMargin_px + 12 + 16.0 * i, colour,
                         files::escape_xml(plot.lines[i].name));
  }
  return svg;
}

/// Returns the elements of a plot, without the header and the end of the SVG.
std::string elements_of(const Plot& plot) {
  const Area area = area_of(plot);
  return fmt::format("<text x=\"{}\" y=\"20\" font-size=\"14\">{}</text>\n", kLeftMargin_px,
                     files::escape_xml(plot.title)) +
         bands_svg(plot, area) + ticks_svg(area) + lines_svg(plot, area) +
         fmt::format(
             "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
             "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}"
             "</text>\n",
             kLeftMargin_px + area.width / 2, plot.height_px - 12, files::escape_xml(plot.x_label),
             kTopMargin_px + area.height / 2, files::escape_xml(plot.y_label));
}

/// The top left corner of each plot of a grid, and the size of the whole.
struct GridLayout {
  std::vector<std::pair<double, double>> corners;
  double width = 0, height = kCaptionHeight_px;
};

GridLayout layout_of(const PlotGrid& grid) {
  GridLayout layout;
  double x = 0, y = kCaptionHeight_px;
  for (std::size_t k = 0; k < grid.plots.size(); ++k) {
    if (k % grid.columns == 0) {
      x = 0;
      y = layout.height;
    }
    layout.corners.emplace_back(x, y);
    x += grid.plots[k].width_px;
    layout.width = std::max(layout.width, x);
    layout.height = std::max(layout.height, y + grid.plots[k].height_px);
  }
  return layout;
}

}  // namespace

std::string svg_of(const Plot& plot) {
  return files::svg_header(plot.width_px, plot.height_px, kFontSize_px) + elements_of(plot) +
         "</svg>\n";
}

std::string svg_of(const PlotGrid& grid) {
  const GridLayout layout = layout_of(grid);
  std::string svg = files::svg_header(layout.width, layout.height, kFontSize_px);
  svg += fmt::format("<text x=\"{}\" y=\"18\">{}</text>\n", kLeftMargin_px,
                     files::escape_xml(grid.caption));
  for (std::size_t k = 0; k < grid.plots.size(); ++k)
    svg += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", layout.corners[k].first,
                       layout.corners[k].second, elements_of(grid.plots[k]));
  return svg + "</svg>\n";
}

}  // namespace morphe::study
