#include "pipeline/report/filmstrip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/convex_hull_2d.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/report/film_instants.hpp"
#include "pipeline/report/outline_points.hpp"
#include "pipeline/report/svg_chart.hpp"

namespace morphe::report {
namespace {

constexpr double kWidth_px = 1000, kTitleHeight_px = 30, kPanelHeight_px = 230,
                 kCaptionHeight_px = 34, kChartHeight_px = 170;
constexpr double kPanelWidth_px = kWidth_px / kFilmPoseCount;

/// A parallel projection of the world; `right` and `up` are axes of the picture.
struct Projection {
  Vec3 right, up, towards_viewer;
};

/// Returns the initial view of the page: in front of the person, on the robot's side, from above.
Projection default_projection(Side side) {
  const Vec3 towards_viewer = Vec3(side == Side::left ? -0.9 : 0.9, 0.75, 0.55).normalized();
  const Vec3 right = Vec3::UnitZ().cross(towards_viewer).normalized();
  return {right, towards_viewer.cross(right), towards_viewer};
}

Vec2 project(const Projection& view, const Vec3& point) {
  return {view.right.dot(point), -view.up.dot(point)};
}

/// A capsule of the robot or a bone of the person, in the world.
struct DrawnCapsule {
  Vec3 from, to;
  double radius;
  std::string_view colour;
};

struct PanelContent {
  FilmInstant instant;
  std::vector<DrawnCapsule> limbs;
  std::vector<Vec3> goals;
  std::vector<Pose> objects;  ///< world_from_object of the scene's objects
};

void add_robot(const robot::Robot& robot, const Pose& world_from_base, const JointVector& q,
               std::vector<DrawnCapsule>& limbs) {
  std::vector<Pose> base_from_frame;
  robot::forward_kinematics(robot, q, base_from_frame);
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    const Pose pose =
        capsule.frame < 0 ? world_from_base : world_from_base * base_from_frame[capsule.frame];
    limbs.push_back({pose * capsule.from, pose * capsule.to, capsule.radius, Colours::kRobot});
  }
}

void add_person(const robot::Robot& robot, const Pose& world_from_base, const Goals& goals,
                PanelContent& panel) {
  constexpr double kArmRadius_m = 0.036, kFingerRadius_m = 0.007;
  const double time_s = panel.instant.demonstration_s;
  const auto frames = frame_interpolation(goals, time_s);
  const auto world_point = [&](const std::vector<Vec3>& points) {
    return Vec3(world_from_base * without_common_offset(goals, interpolate_point(points, frames)));
  };
  const Vec3 shoulder = world_point(goals.shoulder_position);
  const Vec3 elbow = world_point(goals.elbow_position), wrist = world_point(goals.wrist_position);
  const auto add_bone = [&](const Vec3& from, const Vec3& to, double radius) {
    if (is_known(from) && is_known(to)) panel.limbs.push_back({from, to, radius, Colours::kPerson});
  };
  add_bone(shoulder, elbow, kArmRadius_m);
  add_bone(elbow, wrist, 0.8 * kArmRadius_m);
  for (int tip = 0; tip < std::ssize(robot.tips); ++tip) {
    const Vec3 goal = world_from_base * tip_goal_at(goals, tip, time_s);
    if (!is_known(goal)) continue;
    panel.goals.push_back(goal);
    add_bone(wrist, goal, kFingerRadius_m);
  }
}

std::vector<Pose> object_poses(const Plan& plan, const PlanView& view, const DisplayMotion* motion,
                               const FilmInstant& instant) {
  std::vector<Pose> poses;
  for (const SceneObject& object : plan.scene.objects) {
    const bool carried =
        motion && object.name == plan.movement.target && motion->target_moved[instant.row] != 0;
    poses.push_back(view.world_from_base * (carried
                                                ? motion->target_pose[instant.row]
                                                : recorded_pose(object, instant.demonstration_s)));
  }
  return poses;
}

std::vector<PanelContent> panel_contents(const robot::Robot& robot, const Plan& plan,
                                         const PlanView& view) {
  const DisplayMotion* motion = goal_motion(view);
  std::vector<PanelContent> panels;
  for (const FilmInstant& instant : film_instants(plan, view)) {
    PanelContent& panel = panels.emplace_back();
    panel.instant = instant;
    add_person(robot, view.world_from_base, plan.goals, panel);
    if (motion)
      add_robot(robot, view.world_from_base, motion->position.row(instant.row).transpose(),
                panel.limbs);
    panel.objects = object_poses(plan, view, motion, instant);
  }
  return panels;
}

/// The projection's point in the middle of each panel [m], and the scale of all panels.
struct PanelScaling {
  Vec2 middle = Vec2::Zero();
  double scale = 1;  ///< [px / m]
};

PanelScaling fit_panel(const Projection& view, const std::vector<PanelContent>& panels) {
  Vec2 low = Vec2::Constant(kInfinity), high = -low;
  const auto add = [&](const Vec3& point, double radius) {
    const Vec2 projected = project(view, point);
    low = low.cwiseMin(projected - Vec2::Constant(radius));
    high = high.cwiseMax(projected + Vec2::Constant(radius));
  };
  for (const PanelContent& panel : panels) {
    for (const DrawnCapsule& limb : panel.limbs) {
      add(limb.from, limb.radius);
      add(limb.to, limb.radius);
    }
    for (const Vec3& goal : panel.goals) add(goal, 0.02);
  }
  if (!(low.x() <= high.x())) return {Vec2::Zero(), 100};
  const Vec2 size = (high - low).cwiseMax(0.05);
  const double scale =
      std::min((kPanelWidth_px - 12) / size.x(), (kPanelHeight_px - 12) / size.y());
  return {(low + high) / 2, scale};
}

void draw_panel(Svg& svg, const Projection& view, const PanelScaling& scaling, const Plan& plan,
                const PanelContent& panel, const Vec2& corner) {
  const Vec2 centre = corner + Vec2(kPanelWidth_px, kPanelHeight_px) / 2;
  const auto pixel = [&](const Vec3& point) {
    return Vec2(centre + scaling.scale * (project(view, point) - scaling.middle));
  };
  svg.begin_clip(corner, {kPanelWidth_px - 2, kPanelHeight_px});
  for (int i = 0; i < std::ssize(plan.scene.objects); ++i) {
    const SceneObject& object = plan.scene.objects[i];
    std::vector<Vec2> corners;
    for (const Vec3& point : outline_points(object))
      corners.push_back(pixel(panel.objects[i] * point));
    const bool target = object.name == plan.movement.target;
    svg.polygon(math::convex_hull_2d(std::move(corners)),
                target ? Colours::kGoal : Colours::kObject, target ? 0.45 : 0.35);
  }
  std::vector<const DrawnCapsule*> limbs;
  for (const DrawnCapsule& limb : panel.limbs) limbs.push_back(&limb);
  std::ranges::stable_sort(limbs, {}, [&](const DrawnCapsule* limb) {
    return view.towards_viewer.dot(limb->from + limb->to) + limb->radius;
  });
  for (const DrawnCapsule* limb : limbs) {
    const Vec2 from = pixel(limb->from), to = pixel(limb->to);
    const double width = 2 * limb->radius * scaling.scale;
    svg.line(from, to, width + 1.4, "#ffffff");
    svg.line(from, to, width, limb->colour, 0.85);
  }
  for (const Vec3& goal : panel.goals) svg.ring(pixel(goal), 2.4, 1.1, Colours::kGoal);
  svg.end_clip();
  const auto& [time_s, demonstration_s, row, caption] = panel.instant;
  svg.text(corner + Vec2(kPanelWidth_px / 2, kPanelHeight_px + 14), 12, "middle",
           fmt::format("{:.2f} s{}{}", time_s, caption.empty() ? "" : ", ", caption));
}

void draw_charts(Svg& svg, const Plan& plan, const PlanView& view,
                 const std::vector<PanelContent>& panels, double top) {
  const DisplayMotion* motion = goal_motion(view);
  std::vector<double> marks, human_speed;
  for (const PanelContent& panel : panels) marks.push_back(panel.instant.time_s);
  const std::vector<double>& time = motion ? motion->time : plan.goals.time;
  for (const double time_s : motion ? motion->demonstration_time : plan.goals.time)
    human_speed.push_back(view.human_speed[nearest_row(plan.goals.time, time_s)]);
  std::vector<ChartLine> speeds = {{"person", time, human_speed, Colours::kPerson, "5 3"}};
  if (motion && !motion->mean_tip_speed.empty())
    speeds.push_back({"robot", time, motion->mean_tip_speed, Colours::kRobot, ""});
  const Vec2 size(kWidth_px / 2, kChartHeight_px);
  draw_chart(svg, {0, top}, size, "Mean fingertip speed [m/s]", speeds, marks);
  if (!motion || motion->tip_error.rows() == 0) return;
  std::vector<double> max_error_mm, allowed_mm;
  for (Eigen::Index row = 0; row < motion->tip_error.rows(); ++row) {
    double max_m = kUnknown;
    for (const double error : motion->tip_error.row(row)) max_m = std::fmax(max_m, error);
    max_error_mm.push_back(max_m * 1e3);
    const bool grasping = is_grasping_at(plan.movement, motion->demonstration_time[row]);
    allowed_mm.push_back(
        (grasping ? plan.tolerances.tracking_tolerance_grasp : plan.tolerances.tracking_tolerance) *
        1e3);
  }
  draw_chart(svg, {kWidth_px / 2, top}, size, "Largest fingertip error [mm]",
             {{"robot", time, max_error_mm, Colours::kRobot, ""},
              {"allowed", time, allowed_mm, Colours::kFaint, "2 3"}},
             marks);
}

}  // namespace

std::string filmstrip(const robot::Robot& robot, const Plan& plan, const std::string& plan_path,
                      const PlanView& view, bool not_verified) {
  const std::vector<PanelContent> panels = panel_contents(robot, plan, view);
  const Projection projection = default_projection(robot.side);
  const PanelScaling scaling = fit_panel(projection, panels);
  const double charts = kTitleHeight_px + kPanelHeight_px + kCaptionHeight_px;
  Svg svg(kWidth_px, charts + kChartHeight_px, fmt::format("{} by {}", plan_path, robot.name));
  std::string head = fmt::format("{}, {}: {}", plan_path, robot.name, name_of(plan.status()));
  if (plan.reason != Reason::none) head += fmt::format(" ({})", name_of(plan.reason));
  if (not_verified) head += ", not verified";
  svg.text({6, 18}, 14, "start", head);
  svg.text({kWidth_px - 170, 18}, 12, "end", "robot", Colours::kRobot);
  svg.text({kWidth_px - 110, 18}, 12, "end", "person", Colours::kPerson);
  svg.text({kWidth_px - 6, 18}, 12, "end", "goals, target", Colours::kGoal);
  for (int k = 0; k < std::ssize(panels); ++k)
    draw_panel(svg, projection, scaling, plan, panels[k], {k * kPanelWidth_px, kTitleHeight_px});
  if (!plan.goals.time.empty()) draw_charts(svg, plan, view, panels, charts);
  return svg.to_string();
}

}  // namespace morphe::report
