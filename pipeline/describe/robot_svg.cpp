#include "pipeline/describe/robot_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/files/markup.hpp"
#include "core/math/convex_hull_2d.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/describe/svg_labels.hpp"

namespace morphe::describe {
namespace {

constexpr double kPanelWidth_px = 620, kMinPanelHeight_px = 480;
constexpr double kTitleHeight_px = 46, kFooterHeight_px = 46, kMargin_px = 24;

/// The roles of frames, which have one colour each.
enum class Role { trunk, arm, fingers, other };
constexpr std::array<const char*, 4> kRoleColours = {"#8a5a2b", "#1f5fa8", "#2e7d4f", "#9a9a9a"};
const char* colour_of(Role role) { return kRoleColours[static_cast<std::size_t>(role)]; }
constexpr const char* kCentreColour = "#d68910";
constexpr const char* kTipColour = "#c0392b";

/// A robot in the posture in which it is drawn.
struct Drawn {
  const RobotModel& robot;
  const Outlines& outlines;
  std::vector<Pose> base_from_frame = {};
  std::vector<Role> roles = {};

  Vec3 to_base(int frame, const Vec3& point = Vec3::Zero()) const {
    return frame < 0 ? point : base_from_frame[frame] * point;
  }
  Role role(int frame) const { return frame < 0 ? Role::trunk : roles[frame]; }
};

/// Returns the roles of all frames: what moves with the palm and carries a tip is a finger, the way
/// to the palm is the arm from its first joint on, and before it the trunk.
std::vector<Role> roles_of(const RobotModel& robot) {
  std::vector<Role> roles(robot.frames.size(), Role::other);
  std::vector<int> way;
  for (const int frame : robot::ancestors(robot, robot.palm_frame)) way.push_back(frame);
  std::ranges::reverse(way);
  Role role = Role::trunk;
  for (const int frame : way) {
    if (robot.frames[frame].joint >= 0) role = Role::arm;
    roles[frame] = role;
  }
  for (const RobotModel::Tip& tip : robot.tips)
    for (const int frame : robot::ancestors(robot, tip.frame))
      if (roles[frame] == Role::other) roles[frame] = Role::fingers;
  for (int f = 0; f < std::ssize(robot.frames); ++f) {  // bodies that are fixed to these
    const int parent = robot.frames[f].parent;
    if (roles[f] == Role::other && robot.frames[f].joint < 0 && parent >= 0 &&
        roles[parent] != Role::trunk)
      roles[f] = roles[parent];
  }
  return roles;
}

/// The box around all that has a role, in the base frame.
struct Box {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();

  void include(const Vec3& point, double radius) {
    lower = lower.cwiseMin(point - Vec3::Constant(radius));
    upper = upper.cwiseMax(point + Vec3::Constant(radius));
  }
};

Box box_of(const Drawn& drawn) {
  Box box;
  for (int f = 0; f < std::ssize(drawn.robot.frames); ++f)
    if (drawn.role(f) != Role::other) box.include(drawn.to_base(f), 0);
  for (const RobotModel::Tip& tip : drawn.robot.tips)
    box.include(drawn.to_base(tip.frame, tip.transform.translation()), 0);
  for (const RobotModel::Capsule& capsule : drawn.robot.capsules) {
    if (drawn.role(capsule.frame) == Role::other) continue;
    box.include(drawn.to_base(capsule.frame, capsule.from), capsule.radius);
    box.include(drawn.to_base(capsule.frame, capsule.to), capsule.radius);
  }
  return box;
}

/// One drawing: the projection along x (across = 1) or y (across = 0).
struct Panel {
  const Drawn& drawn;
  const Box& box;
  Eigen::Index across;
  double scale;
  SvgPanel place;

  double x(const Vec3& point) const {
    return place.left + place.width / 2 +
           scale * (point[across] - (box.lower[across] + box.upper[across]) / 2);
  }
  double y(const Vec3& point) const {
    return place.top + place.height / 2 - scale * (point.z() - (box.lower.z() + box.upper.z()) / 2);
  }
  std::string line(const Vec3& a, const Vec3& b, double width, const std::string& style) const {
    return fmt::format(
        "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" stroke-width=\"{:.2f}\" "
        "{}/>\n",
        x(a), y(a), x(b), y(b), width, style);
  }
  std::string dot(const Vec3& point, double radius, const std::string& style) const {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" {}/>\n", x(point), y(point),
                       radius, style);
  }
  SvgLabel label(const Vec3& point, const std::string& text, const char* colour) const {
    return {x(point), y(point), text, colour};
  }
  std::string outline(int frame, const std::vector<Vec3>& points) const {
    std::vector<Eigen::Vector2d> flat;
    for (const Vec3& point : points) {
      const Vec3 in_base = drawn.to_base(frame, point);
      flat.emplace_back(x(in_base), y(in_base));
    }
    std::string path;
    for (const Eigen::Vector2d& p : math::convex_hull_2d(std::move(flat)))
      path += fmt::format("{:.2f},{:.2f} ", p.x(), p.y());
    return fmt::format(
        "<polygon points=\"{}\" fill=\"none\" stroke=\"#7a9a6a\" stroke-width=\"0.7\"/>\n", path);
  }
  std::string bone(int parent, const Vec3& to, Role role) const {
    return line(drawn.to_base(parent), to, role == Role::other ? 1 : 2.5,
                fmt::format("stroke=\"{}\" stroke-linecap=\"round\"", colour_of(role)));
  }
  std::string joint(int i) const {
    constexpr double kAxisLength_m = 0.02;
    const char* colour = colour_of(drawn.role(i));
    const Vec3 origin = drawn.to_base(i);
    const Vec3 axis = drawn.to_base(i, kAxisLength_m * drawn.robot.frames[i].axis) - origin;
    return line(origin - axis, origin + axis, 1,
                fmt::format("stroke=\"{}\" stroke-dasharray=\"3 2\"", colour)) +
           dot(origin, 2.6, fmt::format("fill=\"{}\"", colour));
  }
  std::string tip(const RobotModel::Tip& tip) const {
    constexpr double kPadNormalLength_m = 0.015;
    const Vec3 origin = drawn.to_base(tip.frame, tip.transform.translation());
    const Vec3 end = drawn.to_base(tip.frame, tip.transform * Vec3(kPadNormalLength_m, 0, 0));
    return line(origin, end, 1, fmt::format("stroke=\"{}\"", kTipColour)) +
           dot(origin, 3, fmt::format("fill=\"{}\"", kTipColour));
  }
  std::string bodies() const {
    std::string svg;
    for (const auto& [frame, points] : drawn.outlines)
      if (points.size() > 2) svg += outline(frame, points);
    for (const RobotModel::Capsule& capsule : drawn.robot.capsules)
      svg += line(drawn.to_base(capsule.frame, capsule.from),
                  drawn.to_base(capsule.frame, capsule.to), 2 * scale * capsule.radius,
                  "stroke=\"#8aa0b8\" stroke-opacity=\"0.22\" stroke-linecap=\"round\"");
    return svg;
  }
  std::string skeleton() const {
    const RobotModel& robot = drawn.robot;
    std::string svg;
    for (int i = 0; i < std::ssize(robot.frames); ++i)
      svg += bone(robot.frames[i].parent, drawn.to_base(i),
                  drawn.role(i) == Role::other ? Role::other : drawn.role(robot.frames[i].parent));
    for (const RobotModel::Tip& tip : robot.tips)
      svg += bone(tip.frame, drawn.to_base(tip.frame, tip.transform.translation()),
                  drawn.role(tip.frame));
    for (int i = 0; i < std::ssize(robot.frames); ++i)
      if (robot.frames[i].joint >= 0) svg += joint(i);
    return svg;
  }
  std::string marks() const {
    const RobotModel& robot = drawn.robot;
    const std::string ring =
        fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"", kCentreColour);
    std::string svg = dot(drawn.to_base(robot.shoulder_frame), 6, ring);
    for (const RobotModel::JointCentre& c : robot.joint_centres)
      svg += dot(drawn.to_base(c.frame), c.chain == "arm" ? 6 : 4.5, ring);
    for (const RobotModel::Tip& drawn_tip : robot.tips) svg += tip(drawn_tip);
    constexpr double kPalmAxis_m = 0.03;
    const Vec3 palm = drawn.to_base(robot.palm_frame);
    for (const int k : {0, 2})
      svg += line(palm, drawn.to_base(robot.palm_frame, kPalmAxis_m * Vec3::Unit(k)), 1.5,
                  k == 0 ? "stroke=\"#c0392b\"" : "stroke=\"#222\"");
    const double size = 5;
    return svg + fmt::format(
                     "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{}\" height=\"{}\" fill=\"#333\"/>\n",
                     x(Vec3::Zero()) - size, y(Vec3::Zero()) - size / 2, 2 * size, size);
  }
  std::vector<SvgLabel> labels() const {
    const RobotModel& robot = drawn.robot;
    std::vector<SvgLabel> found;
    for (int i = 0; i < std::ssize(robot.frames); ++i)
      if (robot.frames[i].joint >= 0)
        found.push_back(label(drawn.to_base(i), robot.frames[i].name, colour_of(drawn.role(i))));
    for (const RobotModel::Tip& tip : robot.tips)
      found.push_back(
          label(drawn.to_base(tip.frame, tip.transform.translation()), tip.name, kTipColour));
    std::vector<int> centres = {robot.shoulder_frame, robot.palm_frame};
    for (const RobotModel::JointCentre& c : robot.joint_centres)
      if (c.chain == "arm") centres.push_back(c.frame);
    std::ranges::sort(centres);
    centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
    for (const int frame : centres)
      if (robot.frames[frame].joint < 0)
        found.push_back(label(drawn.to_base(frame), robot.frames[frame].name, kCentreColour));
    return found;
  }
  std::string svg_text() const {
    const double inner = place.left + kLabelColumn_px;
    return fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{} view (right: {}, up: z)</text>\n",
                       place.left + kMargin_px, place.top - 6, across == 1 ? "front" : "side",
                       across == 1 ? "y" : "x") +
           fmt::format(
               "<clipPath id=\"view{0}\"><rect x=\"{1:.0f}\" y=\"{2:.0f}\" width=\"{3:.0f}\" "
               "height=\"{4:.0f}\"/></clipPath>\n<g clip-path=\"url(#view{0})\">\n",
               across, inner, place.top, place.width - 2 * kLabelColumn_px, place.height) +
           bodies() + skeleton() + marks() + "</g>\n" + labels_svg(labels(), place);
  }
};

std::string legend(double width, double height, double scale) {
  const double bar = 0.1 * scale, end = width - kMargin_px;
  return fmt::format(
      "<text x=\"{0:.0f}\" y=\"{6:.0f}\" font-size=\"12\">chains: <tspan fill=\"{7}\">trunk</tspan>"
      ", <tspan fill=\"{8}\">arm</tspan>, <tspan fill=\"{9}\">fingers</tspan>, <tspan "
      "fill=\"{10}\">other</tspan>; dashed: joint axis; <tspan fill=\"{11}\">ring: joint "
      "centre</tspan>; <tspan fill=\"{12}\">tip and normal of its pad</tspan></text>\n"
      "<text x=\"{0:.0f}\" y=\"{1:.0f}\" font-size=\"12\">grey: capsule; green outline: mesh; "
      "black: base, and direction of the fingers at the palm; joints as near to 0 as their limits "
      "allow</text>\n"
      "<path d=\"M{2:.2f} {1:.0f}h{3:.2f}\" stroke=\"#333\" stroke-width=\"2\"/>\n"
      "<text x=\"{4:.0f}\" y=\"{5:.0f}\" font-size=\"12\" text-anchor=\"end\">100 mm</text>\n",
      kMargin_px, height - 10, end - bar, bar, end, height - 16, height - 26,
      colour_of(Role::trunk), colour_of(Role::arm), colour_of(Role::fingers),
      colour_of(Role::other), kCentreColour, kTipColour);
}

}  // namespace

std::string robot_svg(const RobotModel& robot, const Outlines& outlines) {
  Drawn drawn{robot, outlines};
  const JointVector zero = JointVector::Zero(robot.lower.size());
  robot::forward_kinematics(robot, zero.cwiseMax(robot.lower).cwiseMin(robot.upper),
                            drawn.base_from_frame);
  drawn.roles = roles_of(robot);
  const Box box = box_of(drawn);
  const double room = kPanelWidth_px - 2 * (kLabelColumn_px + kMargin_px);
  const Vec3 extent = (box.upper - box.lower).cwiseMax(Vec3::Constant(1e-6));
  const double scale =
      std::min(room / std::max(extent.x(), extent.y()), (2 * room - kTitleHeight_px) / extent.z());
  std::vector<Panel> panels;
  double panel_height = std::max(kMinPanelHeight_px, scale * extent.z() + 2 * kMargin_px);
  for (const Eigen::Index across : {1, 0}) {
    const SvgPanel place{across == 1 ? 0 : kPanelWidth_px, kTitleHeight_px + 20, kPanelWidth_px, 0};
    panels.push_back({drawn, box, across, scale, place});
    panel_height = std::max(panel_height, height_for_labels(panels.back().labels(), place));
  }
  const double width = 2 * kPanelWidth_px;
  const double height = kTitleHeight_px + 20 + panel_height + kFooterHeight_px;
  std::string svg = files::svg_header(width, height, 13);
  svg += fmt::format("<text x=\"{:.0f}\" y=\"28\" font-size=\"17\">{}: {}</text>\n", kMargin_px,
                     files::escape_xml(robot.name), count_with_noun(robot.joints(), "joint"));
  for (Panel& panel : panels) {
    panel.place.height = panel_height;
    svg += panel.svg_text();
  }
  return svg + legend(width, height, scale) + "</svg>\n";
}

}  // namespace morphe::describe
