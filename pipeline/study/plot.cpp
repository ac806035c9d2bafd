#include "pipeline/study/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files/markup.hpp"

namespace morphe::study {
namespace {

constexpr double kWidth = 900, kHeight = 360;
constexpr double kLeft = 70, kRight = 180, kTop = 40, kBottom = 50;
constexpr const char* kColours[] = {"#1f5fa8", "#c0392b", "#2e8b57", "#8e5ea2", "#d68910",
                                    "#17808f", "#7f4f24", "#555555", "#b03a7a", "#6b8e23"};
constexpr const char* kShades[] = {"#dfe9f5", "#f7e3d9"};

/// An axis with round ticks: 1, 2 or 5 times a power of ten apart, about six of them.
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
  void take(double value) {
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
    for (const double x : line.x) xs.take(x);
    for (const double y : line.y) ys.take(y);
  }
  for (const Plot::Band& band : plot.bands) {
    xs.take(band.begin);
    xs.take(band.end);
  }
  const double inner = kWidth - kLeft - kRight, tall = kHeight - kTop - kBottom;
  if (plot.same_scale && xs.least <= xs.most && ys.least <= ys.most) {
    const double metre = std::min(inner / (xs.most - xs.least), tall / (ys.most - ys.least));
    widen(xs, inner / metre);
    widen(ys, tall / metre);
  }
  const Axis x_axis(xs.least, xs.most, !plot.same_scale);
  const Axis y_axis(ys.least, ys.most, !plot.same_scale);
  const auto px = [&](double x) {
    return kLeft + inner * (x - x_axis.low) / (x_axis.high - x_axis.low);
  };
  const auto py = [&](double y) {
    return kHeight - kBottom - tall * (y - y_axis.low) / (y_axis.high - y_axis.low);
  };
  std::string svg = files::svg_begin(kWidth, kHeight, 12);
  svg += fmt::format("<text x=\"{}\" y=\"20\" font-size=\"14\">{}</text>\n", kLeft,
                     files::xml_escaped(plot.title));
  for (std::size_t i = 0; i < plot.bands.size(); ++i) {
    const Plot::Band& band = plot.bands[i];
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n"
        "<text x=\"{:.1f}\" y=\"{}\" font-size=\"10\" fill=\"#555\">{}</text>\n",
        px(band.begin), kTop, px(band.end) - px(band.begin), tall, kShades[i % std::size(kShades)],
        px(band.begin) + 2, kTop + 10 + 11 * static_cast<double>(i % 3),
        files::xml_escaped(band.name));
  }
  const auto ticks = [](const Axis& axis) {
    return static_cast<int>(std::floor((axis.high - axis.first) / axis.step + 1e-9));
  };
  for (int k = 0; k <= ticks(x_axis); ++k) {
    const double x = x_axis.first + k * x_axis.step;
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:.6g}</text>\n",
        px(x), kTop, kHeight - kBottom, kHeight - kBottom + 16, x);
  }
  for (int k = 0; k <= ticks(y_axis); ++k) {
    const double y = y_axis.first + k * y_axis.step;
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/>\n"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.6g}</text>\n",
        kLeft, kWidth - kRight, py(y), kLeft - 6, py(y) + 4, y);
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
    svg +=
        fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", kWidth - kRight + 10,
                    kTop + 12 + 16 * static_cast<double>(i), colour, files::xml_escaped(line.name));
  }
  svg += fmt::format(
      "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
      "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n"
      "</svg>\n",
      kLeft + inner / 2, kHeight - 12, files::xml_escaped(plot.x_label), kTop + tall / 2,
      files::xml_escaped(plot.y_label));
  return svg;
}

}  // namespace morphe::study
