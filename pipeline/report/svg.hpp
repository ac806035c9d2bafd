#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::report {

using Vec2 = Eigen::Vector2d;

/// Colours that people with any colour vision tell apart (Okabe and Ito 2008).
struct Colours {
  static constexpr std::string_view kRobot = "#0072b2", kPerson = "#d55e00", kGoal = "#009e73",
                                    kObject = "#bbbbbb", kBad = "#cc79a7", kInk = "#000000",
                                    kFaint = "#888888";
};

/// An SVG that is written from back to front. Units are pixels, y down. What is not finite is left
/// out.
class Svg {
 public:
  Svg(double width, double height, std::string_view title);

  void line(const Vec2& from, const Vec2& to, double width, std::string_view colour,
            double opacity = 1, std::string_view dash = "");
  void polygon(const std::vector<Vec2>& corners, std::string_view colour, double opacity);
  /// Breaks where a point is not finite.
  void polyline(const std::vector<Vec2>& points, double width, std::string_view colour,
                std::string_view dash = "");
  void dot(const Vec2& centre, double radius, std::string_view colour);
  void ring(const Vec2& centre, double radius, double width, std::string_view colour);
  /// anchor: start, middle or end.
  void text(const Vec2& at, double size, std::string_view anchor, std::string_view words,
            std::string_view colour = Colours::kInk);
  /// What follows is seen inside a rectangle alone, until end_clip().
  void begin_clip(const Vec2& corner, const Vec2& size);
  void end_clip();
  std::string finished() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
  int clips_ = 0;
};

}  // namespace morphe::report
