#include "pipeline/study/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/files/markup.hpp"
#include "core/motion/geometry.hpp"

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

  Axis(double lo, double hi, bool rounded) {
    if (!(lo <= hi)) return;
    const double span = hi > lo ? hi - lo : std::max(1.0, std::abs(hi));
    const double rough = span / 6, power = std::pow(10, std::floor(std::log10(rough)));
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
  constexpr double kAreaWidth_px = kWidth_px - kLeftMargin_px - kRightMargin_px,
                   kAreaHeight_px = kHeight_px - kTopMargin_px - kBottomMargin_px;
  if (plot.same_scale && xs.low <= xs.high && ys.low <= ys.high) {
    const double scale =
        std::min(kAreaWidth_px / (xs.high - xs.low), kAreaHeight_px / (ys.high - ys.low));
    widen(xs, kAreaWidth_px / scale);
    widen(ys, kAreaHeight_px / scale);
  }
  const Axis x_axis(xs.low, xs.high, !plot.same_scale);
  const Axis y_axis(ys.low, ys.high, !plot.same_scale);
  const auto px = [&](double x) {
    return kLeftMargin_px + kAreaWidth_px * (x - x_axis.low) / (x_axis.high - x_axis.low);
  };
  const auto py = [&](double y) {
    return kHeight_px - kBottomMargin_px -
           kAreaHeight_px * (y - y_axis.low) / (y_axis.high - y_axis.low);
  };
  std::string svg = files::svg_header(kWidth_px, kHeight_px, 12);
  svg += fmt::format("<text x=\"{}\" y=\"20\" font-size=\"14\">{}</text>\n", kLeftMargin_px,
                     files::escape_xml(plot.title));
  for (int i = 0; i < std::ssize(plot.bands); ++i) {
    const Plot::Band& band = plot.bands[i];
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n"
        "<text x=\"{:.1f}\" y=\"{}\" font-size=\"10\" fill=\"#555\">{}</text>\n",
        px(band.begin), kTopMargin_px, px(band.end) - px(band.begin), kAreaHeight_px,
        kShades[i % std::ssize(kShades)], px(band.begin) + 2, kTopMargin_px + 10 + 11.0 * (i % 3),
        files::escape_xml(band.name));
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
  for (int i = 0; i < std::ssize(plot.lines); ++i) {
    const Plot::Line& line = plot.lines[i];
    const char* colour = kColours[i % std::ssize(kColours)];
    std::string path, dots;
    bool interrupted = true;
    for (int k = 0; k < std::min(std::ssize(line.x), std::ssize(line.y)); ++k) {
      const bool known = std::isfinite(line.x[k]) && std::isfinite(line.y[k]);
      if (known) {
        const double x = px(line.x[k]), y = py(line.y[k]);
        path += fmt::format("{}{:.1f} {:.1f}", interrupted ? "M" : "L", x, y);
        if (line.dots)
          dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", x, y,
                              colour);
      }
      interrupted = !known;
    }
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n{}",
                       path, colour, dots);
    svg += fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n",
                       kWidth_px - kRightMargin_px + 10, kTopMargin_px + 12 + 16.0 * i, colour,
                       files::escape_xml(line.name));
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
      "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n"
      "</svg>\n",
      kLeftMargin_px + kAreaWidth_px / 2, kHeight_px - 12, files::escape_xml(plot.x_label),
      kTopMargin_px + kAreaHeight_px / 2, files::escape_xml(plot.y_label));
  return svg;
}

}  // namespace morphe::study
