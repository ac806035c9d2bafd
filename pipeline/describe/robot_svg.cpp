#include "pipeline/describe/robot_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "core/files/markup.hpp"
#include "core/math/convex_hull_2d.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::describe {
namespace {

constexpr double kPanelSize_px = 430, kTitleHeight_px = 46, kFooterHeight_px = 46, kMargin_px = 24;
constexpr double kBentAngle_rad = std::numbers::pi / 6;

struct DrawnPosture {
  const char* name;
  std::vector<Pose> base_from_frame;

  Vec3 to_base(int frame, const Vec3& point = Vec3::Zero()) const {
    return frame < 0 ? point : base_from_frame[frame] * point;
  }
};

/// The box around all drawn bodies and the origin of the base, in the base frame.
struct Box {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();

  void include(const Vec3& point, double radius) {
    lower = lower.cwiseMin(point - Vec3::Constant(radius));
    upper = upper.cwiseMax(point + Vec3::Constant(radius));
  }
};

/// One drawing: a posture in the projection along x (across = 1) or y (across = 0).
struct Panel {
  const RobotModel& robot;
  const DrawnPosture& posture;
  const Outlines& outlines;
  const Box& box;
  Eigen::Index across;
  double scale, left, top;

  double x(const Vec3& point) const {
    return left + kPanelSize_px / 2 +
           scale * (point[across] - (box.lower[across] + box.upper[across]) / 2);
  }
  double y(const Vec3& point) const {
    return top + kPanelSize_px / 2 - scale * (point.z() - (box.lower.z() + box.upper.z()) / 2);
  }
  std::string line(const Vec3& a, const Vec3& b, double width, const char* style) const {
    return fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke-width=\"{:.2f}\" "
        "{}/>\n",
        x(a), y(a), x(b), y(b), width, style);
  }
  std::string dot(const Vec3& point, double radius, const char* style) const {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" {}/>\n", x(point), y(point),
                       radius, style);
  }
  std::string label(const Vec3& p, double dy, const char* colour, const std::string& name) const {
    return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"5\" fill=\"{}\">{}</text>\n",
                       x(p) + 4, y(p) + dy, colour, files::escape_xml(name));
  }
  std::string outline(int frame, const std::vector<Vec3>& points) const {
    std::vector<Eigen::Vector2d> flat;
    for (const Vec3& point : points) {
      const Vec3 in_base = posture.to_base(frame, point);
      flat.emplace_back(x(in_base), y(in_base));
    }
    std::string path;
    for (const Eigen::Vector2d& p : math::convex_hull_2d(std::move(flat)))
      path += fmt::format("{:.2f},{:.2f} ", p.x(), p.y());
    return fmt::format(
        "<polygon points=\"{}\" fill=\"none\" stroke=\"#7a9a6a\" stroke-width=\"0.7\"/>\n", path);
  }
  std::string joint(int i) const {
    constexpr double kAxisLength_m = 0.02;
    const Vec3 origin = posture.to_base(i);
    const Vec3 axis = posture.to_base(i, kAxisLength_m * robot.frames[i].axis) - origin;
    return line(origin - axis, origin + axis, 1, "stroke=\"#1f5fa8\" stroke-dasharray=\"3 2\"") +
           dot(origin, 2.6, "fill=\"#1f5fa8\"") +
           label(origin, -3, "#1f5fa8", robot.frames[i].name);
  }
  std::string tip(const RobotModel::Tip& tip) const {
    constexpr double kPadNormalLength_m = 0.015;
    const Vec3 origin = posture.to_base(tip.frame, tip.transform.translation());
    const Vec3 normal_end =
        posture.to_base(tip.frame, tip.transform * Vec3(kPadNormalLength_m, 0, 0));
    return line(origin, normal_end, 1, "stroke=\"#c0392b\"") + dot(origin, 3, "fill=\"#c0392b\"") +
           label(origin, 5, "#c0392b", tip.name);
  }

  std::string svg_text() const {
    std::string svg = fmt::format(
        "<text x=\"{:.0f}\" y=\"{:.0f}\">{}, {} (right: {}, up: z)</text>\n", left + kMargin_px,
        top + 16, posture.name, across == 1 ? "front" : "side", across == 1 ? "y" : "x");
    for (const auto& [frame, points] : outlines)
      if (points.size() > 2) svg += outline(frame, points);
    for (const RobotModel::Capsule& capsule : robot.capsules)
      svg += line(posture.to_base(capsule.frame, capsule.from),
                  posture.to_base(capsule.frame, capsule.to), 2 * scale * capsule.radius,
                  "stroke=\"#8aa0b8\" stroke-opacity=\"0.28\" stroke-linecap=\"round\"");
    const auto bone = [&](int parent, const Vec3& to) {
      return line(posture.to_base(parent), to, 2, "stroke=\"#333\" stroke-linecap=\"round\"");
    };
    for (int i = 0; i < std::ssize(robot.frames); ++i)
      svg += bone(robot.frames[i].parent, posture.to_base(i));
    for (const RobotModel::Tip& tip : robot.tips)
      svg += bone(tip.frame, posture.to_base(tip.frame, tip.transform.translation()));
    for (int i = 0; i < std::ssize(robot.frames); ++i)
      if (robot.frames[i].joint >= 0) svg += joint(i);
    for (const RobotModel::JointCentre& c : robot.joint_centres)
      svg +=
          dot(posture.to_base(c.frame), 5, "fill=\"none\" stroke=\"#d68910\" stroke-width=\"1.5\"");
    for (const RobotModel::Tip& drawn_tip : robot.tips) svg += tip(drawn_tip);
    const double size = 5;
    return svg + fmt::format(
                     "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{}\" height=\"{}\" fill=\"#333\"/>\n",
                     x(Vec3::Zero()) - size, y(Vec3::Zero()) - size / 2, 2 * size, size);
  }
};

DrawnPosture posture(const RobotModel& robot, const char* name, const JointVector& q) {
  DrawnPosture result{name, {}};
  robot::forward_kinematics(robot, q, result.base_from_frame);
  return result;
}

}  // namespace

std::string robot_svg(const RobotModel& robot, const Outlines& outlines) {
  const JointVector zero = JointVector::Zero(robot.lower.size());
  const JointVector bent = JointVector::Constant(robot.lower.size(), kBentAngle_rad);
  const auto allowed = [&](const JointVector& q) -> JointVector {
    return q.cwiseMax(robot.lower).cwiseMin(robot.upper);
  };
  const std::array<DrawnPosture, 2> postures = {posture(robot, "all joints 0", allowed(zero)),
                                                posture(robot, "all joints 30 deg", allowed(bent))};
  Box box;
  for (const DrawnPosture& p : postures) {
    for (int i = 0; i < std::ssize(robot.frames); ++i) box.include(p.to_base(i), 0);
    for (const RobotModel::Tip& tip : robot.tips)
      box.include(p.to_base(tip.frame, tip.transform.translation()), 0);
    for (const RobotModel::Capsule& capsule : robot.capsules) {
      box.include(p.to_base(capsule.frame, capsule.from), capsule.radius);
      box.include(p.to_base(capsule.frame, capsule.to), capsule.radius);
    }
  }
  const double extent = (box.upper - box.lower).maxCoeff();
  const double scale = (kPanelSize_px - 2 * kMargin_px) / std::max(extent, 1e-6);
  const double width = 2 * kPanelSize_px,
               height = kTitleHeight_px + 2 * kPanelSize_px + kFooterHeight_px;
  std::string svg = files::svg_header(width, height, 13);
  svg += fmt::format("<text x=\"{:.0f}\" y=\"28\" font-size=\"17\">{}: {}</text>\n", kMargin_px,
                     files::escape_xml(robot.name), count_with_noun(robot.joints(), "joint"));
  for (int row = 0; row < std::ssize(postures); ++row) {
    for (const Eigen::Index across : {1, 0}) {
      const double left = across == 1 ? 0 : kPanelSize_px;
      const double top = kTitleHeight_px + kPanelSize_px * row;
      svg += Panel{robot, postures[row], outlines, box, across, scale, left, top}.svg_text();
    }
  }
  const double foot = height - 10, bar = 0.1 * scale, end = width - kMargin_px;
  svg += fmt::format(
      "<text x=\"{0:.0f}\" y=\"{6:.0f}\" font-size=\"12\">blue: joint and its axis, orange: joint "
      "centre of metric A, red: tip and normal of its pad</text>\n"
      "<text x=\"{0:.0f}\" y=\"{1:.0f}\" font-size=\"12\">grey: capsule, green: mesh, black: base; "
      "joints as close to these values as their limits allow</text>\n"
      "<path d=\"M{2:.2f} {1:.0f}h{3:.2f}\" stroke=\"#333\" stroke-width=\"2\"/>\n"
      "<text x=\"{4:.0f}\" y=\"{5:.0f}\" font-size=\"12\" text-anchor=\"end\">100 mm</text>\n",
      kMargin_px, foot, end - bar, bar, end, foot - 6, foot - 16);
  return svg + "</svg>\n";
}

}  // namespace morphe::describe
