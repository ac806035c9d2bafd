#include "pipeline/study/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files/markup.hpp"

namespace morphe::study {
namespace {

constexpr double kWidth_px = 900, kHeight_px = 360;
constexpr double kLeftMargin_px = 70, kRightMargin_px = 180, kTopMargin_px = 40,
                 kBottomMargin_px = 50;
constexpr const char* kColours[] = {"#1f5fa8", "#c0392b", "#2e8b57", "#8e5ea2", "#d68910",
                                    "#17808f", "#7f4f24", "#555555", "#b03a7a", "#6b8e23"};
constexpr const char* kShades[] = {"#dfe9f5", "#f7e3d9"};

/// An axis with about six round ticks whose distance is 1, 2 or 5 times a power of ten.
struct Axis {
  double low = 0, high = 1, step = 0.2, first = 0;

  Axis(double least, double most, bool rounded) {
    if (!(least <= most)) return;
    const double span = most > least ? most - least : std::max(1.0, std::abs(most));
    const double rough = span / 6, power = std::pow(10, std::floor(std::log10(rough)));
    step = power * (rough / power < 1.5   ? 1
                    : rough / power < 3.5 ? 2
                    : rough / power < 7.5 ? 5
                                          : 10);
    first = (rounded ? std::floor(least / step) : std::ceil(least / step)) * step;
    low = rounded ? first : least;
    high = rounded ? std::ceil(most / step) * step : most;
    if (high <= low) high = low + step;
  }
};

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  void extend(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

void widen(Range& range, double width) {
  const double more = (width - (range.most - range.least)) / 2;
  range.least -= more;
  range.most += more;
}

}  // namespace

std::string svg_of(const Plot& plot) {
  Range xs, ys;
  for (const Plot::Line& line : plot.lines) {
    for (const double x : line.x) xs.extend(x);
    for (const double y : line.y) ys.extend(y);
  }
  for (const Plot::Band& band : plot.bands) {
    xs.extend(band.begin);
    xs.extend(band.end);
  }
  const double inner = kWidth_px - kLeftMargin_px - kRightMargin_px,
               tall = kHeight_px - kTopMargin_px - kBottomMargin_px;
  if (plot.same_scale && xs.least <= xs.most && ys.least <= ys.most) {
    const double metre = std::min(inner / (xs.most - xs.least), tall / (ys.most - ys.least));
    widen(xs, inner / metre);
    widen(ys, tall / metre);
  }
  const Axis x_axis(xs.least, xs.most, !plot.same_scale);
  const Axis y_axis(ys.least, ys.most, !plot.same_scale);
  const auto px = [&](double x) {
    return kLeftMargin_px + inner * (x - x_axis.low) / (x_axis.high - x_axis.low);
  };
  const auto py = [&](double y) {
    return kHeight_px - kBottomMargin_px - tall * (y - y_axis.low) / (y_axis.high - y_axis.low);
  };
  std::string svg = files::svg_header(kWidth_px, kHeight_px, 12);
  svg += fmt::format("<text x=\"{}\" y=\"20\" font-size=\"14\">{}</text>\n", kLeftMargin_px,
                     files::escape_xml(plot.title));
  for (std::size_t i = 0; i < plot.bands.size(); ++i) {
    const Plot::Band& band = plot.bands[i];
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n"
        "<text x=\"{:.1f}\" y=\"{}\" font-size=\"10\" fill=\"#555\">{}</text>\n",
        px(band.begin), kTopMargin_px, px(band.end) - px(band.begin), tall,
        kShades[i % std::size(kShades)], px(band.begin) + 2,
        kTopMargin_px + 10 + 11 * static_cast<double>(i % 3), files::escape_xml(band.name));
  }
  const auto ticks = [](const Axis& axis) {
    return static_cast<int>(std::floor((axis.high - axis.first) / axis.step + 1e-9));
  };
  for (int k = 0; k <= ticks(x_axis); ++k) {
    const double x = x_axis.first + k * x_axis.step;
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:.6g}</text>\n",
        px(x), kTopMargin_px, kHeight_px - kBottomMargin_px, kHeight_px - kBottomMargin_px + 16, x);
  }
  for (int k = 0; k <= ticks(y_axis); ++k) {
    const double y = y_axis.first + k * y_axis.step;
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.6g}</text>\n",
        kLeftMargin_px, kWidth_px - kRightMargin_px, py(y), kLeftMargin_px - 6, py(y) + 4, y);
  }
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    const Plot::Line& line = plot.lines[i];
    const char* colour = kColours[i % std::size(kColours)];
    std::string path;
    bool open = false;
    for (std::size_t k = 0; k < std::min(line.x.size(), line.y.size()); ++k) {
      if (!std::isfinite(line.x[k]) || !std::isfinite(line.y[k])) {
        open = false;
        continue;
      }
      path += fmt::format("{}{:.1f} {:.1f}", open ? "L" : "M", px(line.x[k]), py(line.y[k]));
      open = true;
    }
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path,
                       colour);
    for (std::size_t k = 0; line.dots && k < std::min(line.x.size(), line.y.size()); ++k) {
      if (!std::isfinite(line.x[k]) || !std::isfinite(line.y[k])) continue;
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n",
                         px(line.x[k]), py(line.y[k]), colour);
    }
    svg += fmt::format(
        "<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", kWidth_px - kRightMargin_px + 10,
        kTopMargin_px + 12 + 16 * static_cast<double>(i), colour, files::escape_xml(line.name));
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
      "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n"
      "</svg>\n",
      kLeftMargin_px + inner / 2, kHeight_px - 12, files::escape_xml(plot.x_label),
      kTopMargin_px + tall / 2, files::escape_xml(plot.y_label));
  return svg;
}

}  // namespace morphe::study
