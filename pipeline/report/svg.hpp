#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::report {

/// A point in the picture [px].
using Vec2 = Eigen::Vector2d;

/// Colours that can be distinguished with any colour vision (Okabe and Ito 2008).
struct Colours {
  static constexpr std::string_view kRobot = "#0072b2", kPerson = "#d55e00", kGoal = "#009e73",
                                    kObject = "#bbbbbb", kInk = "#000000", kFaint = "#888888";
};

/// An SVG that is written from back to front. Units are pixels, y points down. Lines and circles
/// with a point that is not finite are left out.
class Svg {
 public:
  /// Begins a picture of the given size.
  Svg(double width, double height, std::string_view title);

  /// Draws a line.
  void line(const Vec2& from, const Vec2& to, double width, std::string_view colour,
            double opacity = 1, std::string_view dash = "");
  /// Draws a filled polygon, if it has at least three corners. They must be finite.
  void polygon(const std::vector<Vec2>& corners, std::string_view colour, double opacity);
  /// Draws a polyline, interrupted at points that are not finite.
  void polyline(const std::vector<Vec2>& points, double width, std::string_view colour,
                std::string_view dash = "");
  /// Draws a circle without filling it.
  void ring(const Vec2& centre, double radius, double width, std::string_view colour);
  /// Writes a text; the anchor is start, middle or end.
  void text(const Vec2& position, double size, std::string_view anchor, std::string_view text,
            std::string_view colour = Colours::kInk);
  /// Clips the following elements to a rectangle, until end_clip().
  void begin_clip(const Vec2& corner, const Vec2& size);
  /// Ends the clipping.
  void end_clip();
  /// Returns the complete SVG.
  std::string to_string() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
  int clip_count_ = 0;
};

}  // namespace morphe::report
