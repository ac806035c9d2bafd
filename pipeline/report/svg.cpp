#include "pipeline/report/svg.hpp"

#include <fmt/format.h>

#include "core/files/markup.hpp"

namespace morphe::report {
namespace {

std::string dashed(std::string_view dash) {
  return dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", dash);
}

}  // namespace

Svg::Svg(double width, double height, std::string_view title)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                        "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" "
                        "role=\"img\">\n<title>{2}</title>\n"
                        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
                        width, height, files::escape_xml(title))) {}

void Svg::line(const Vec2& from, const Vec2& to, double width, std::string_view colour,
               double opacity, std::string_view dash) {
  if (!from.allFinite() || !to.allFinite()) return;
  text_ += fmt::format(
      "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke=\"{}\" "
      "stroke-width=\"{:.2f}\" stroke-linecap=\"round\" opacity=\"{:.2f}\"{}/>\n",
      from.x(), from.y(), to.x(), to.y(), colour, width, opacity, dashed(dash));
}

void Svg::polygon(const std::vector<Vec2>& corners, std::string_view colour, double opacity) {
  if (corners.size() < 3) return;
  text_ += "<polygon points=\"";
  for (const Vec2& corner : corners) text_ += fmt::format("{:.2f},{:.2f} ", corner.x(), corner.y());
  text_ += fmt::format("\" fill=\"{}\" opacity=\"{:.2f}\" stroke=\"{}\"/>\n", colour, opacity,
                       Colours::kFaint);
}

void Svg::polyline(const std::vector<Vec2>& points, double width, std::string_view colour,
                   std::string_view dash) {
  std::string path;
  bool drawing = false;
  for (const Vec2& point : points) {
    const bool seen = point.allFinite();
    if (seen) path += fmt::format("{}{:.2f} {:.2f} ", drawing ? 'L' : 'M', point.x(), point.y());
    drawing = seen;
  }
  if (path.empty()) return;
  text_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\"{}/>\n",
                       path, colour, width, dashed(dash));
}

void Svg::ring(const Vec2& centre, double radius, double width, std::string_view colour) {
  if (!centre.allFinite()) return;
  text_ += fmt::format(
      "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"{:.2f}\"/>\n",
      centre.x(), centre.y(), radius, colour, width);
}

void Svg::text(const Vec2& position, double size, std::string_view anchor, std::string_view text,
               std::string_view colour) {
  text_ += fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.1f}\" text-anchor=\"{}\" "
      "fill=\"{}\">{}</text>\n",
      position.x(), position.y(), size, anchor, colour, files::escape_xml(text));
}

void Svg::begin_clip(const Vec2& corner, const Vec2& size) {
  const int id = clip_count_++;
  text_ += fmt::format(
      "<clipPath id=\"clip{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" "
      "height=\"{4:.2f}\"/></clipPath>\n<g clip-path=\"url(#clip{0})\">\n",
      id, corner.x(), corner.y(), size.x(), size.y());
}

void Svg::end_clip() { text_ += "</g>\n"; }

}  // namespace morphe::report
