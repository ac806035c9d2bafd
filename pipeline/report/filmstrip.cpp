#include "pipeline/report/filmstrip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// A parallel projection of the world: `right` and `up` in the picture, the third axis towards the
/// viewer.
struct Projection {
  Vec3 right, up, towards_viewer;
};

/// Returns the view from in front of the person, on the robot's side, from above, as in the initial
/// view of the page.
Projection default_projection(Side side) {
  const Vec3 near = Vec3(side == Side::left ? -0.9 : 0.9, 0.75, 0.55).normalized();
  const Vec3 right = Vec3::UnitZ().cross(near).normalized();
  return {right, near.cross(right), near};
}

Vec2 project(const Projection& view, const Vec3& point) {
  return {view.right.dot(point), -view.up.dot(point)};
}

/// A capsule in the world, which also represents a bone.
struct DrawnCapsule {
  Vec3 from, to;
  double radius;
  std::string_view colour;
};

/// The content of one panel.
struct PanelContent {
  double time_s = kUnknown, demonstration_s = kUnknown;
  std::vector<DrawnCapsule> limbs;
  std::vector<Vec3> goals;
  std::vector<Pose> objects;  ///< world_from_object of the scene's objects
  std::string words;
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
                double demonstration_s, PanelContent& scenery) {
  constexpr double kArmRadius_m = 0.036, kFingerRadius_m = 0.007;
  const auto when = frame_interpolation(goals, demonstration_s);
  const auto seen_at = [&](const std::vector<Vec3>& points) {
    return Vec3(world_from_base * without_common_offset(goals, interpolate_point(points, when)));
  };
  const Vec3 shoulder = seen_at(goals.shoulder_position), elbow = seen_at(goals.elbow_position);
  const Vec3 wrist = seen_at(goals.wrist_position);
  const auto bone = [&](const Vec3& from, const Vec3& to, double radius) {
    if (is_known(from) && is_known(to))
      scenery.limbs.push_back({from, to, radius, Colours::kPerson});
  };
  bone(shoulder, elbow, kArmRadius_m);
  bone(elbow, wrist, 0.8 * kArmRadius_m);
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const Vec3 goal = world_from_base * tip_goal_at(goals, tip, demonstration_s);
    if (!is_known(goal)) continue;
    scenery.goals.push_back(goal);
    bone(wrist, goal, kFingerRadius_m);
  }
}

std::vector<Pose> object_poses(const Plan& plan, const PlanView& view, const DisplayMotion* motion,
                               std::size_t row, double demonstration_s) {
  std::vector<Pose> poses;
  for (const SceneObject& object : plan.scene.objects) {
    const bool carried =
        motion && object.name == plan.movement.target && motion->target_moved[row] != 0;
    poses.push_back(view.world_from_base *
                    (carried ? motion->target_pose[row] : recorded_pose(object, demonstration_s)));
  }
  return poses;
}

std::vector<PanelContent> panel_contents(const robot::Robot& robot, const Plan& plan,
                                         const PlanView& view) {
  const DisplayMotion* motion = goal_motion(view);
  std::vector<PanelContent> sceneries;
  for (const FilmInstant& instant : film_instants(plan, view)) {
    PanelContent scenery;
    scenery.time_s = instant.time_s;
    scenery.demonstration_s = instant.demonstration_s;
    scenery.words = instant.caption;
    add_person(robot, view.world_from_base, plan.goals, instant.demonstration_s, scenery);
    if (motion)
      add_robot(robot, view.world_from_base, motion->position.row(instant.row).transpose(),
                scenery.limbs);
    scenery.objects = object_poses(plan, view, motion, instant.row, instant.demonstration_s);
    sceneries.push_back(std::move(scenery));
  }
  return sceneries;
}

/// The position and the scale of the world in a panel, equal in all panels.
struct PanelScaling {
  Vec2 middle = Vec2::Zero();
  double scale = 1;  ///< scale [px / m]
};

PanelScaling fit_panel(const Projection& view, const std::vector<PanelContent>& sceneries) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const auto add = [&](const Vec3& point, double radius) {
    const Vec2 at = project(view, point);
    low = low.cwiseMin(at - Vec2::Constant(radius));
    high = high.cwiseMax(at + Vec2::Constant(radius));
  };
  for (const PanelContent& scenery : sceneries) {
    for (const DrawnCapsule& limb : scenery.limbs) {
      add(limb.from, limb.radius);
      add(limb.to, limb.radius);
    }
    for (const Vec3& goal : scenery.goals) add(goal, 0.02);
  }
  if (!(low.x() <= high.x())) return {Vec2::Zero(), 100};
  const Vec2 size = (high - low).cwiseMax(0.05);
  const double scale =
      std::min((kPanelWidth_px - 12) / size.x(), (kPanelHeight_px - 12) / size.y());
  return {(low + high) / 2, scale};
}

void draw_panel(Svg& svg, const Projection& view, const PanelScaling& frame, const Plan& plan,
                const PanelContent& scenery, const Vec2& corner) {
  const Vec2 centre = corner + Vec2(kPanelWidth_px, kPanelHeight_px) / 2;
  const auto place = [&](const Vec3& point) {
    return Vec2(centre + frame.scale * (project(view, point) - frame.middle));
  };
  svg.begin_clip(corner, {kPanelWidth_px - 2, kPanelHeight_px});
  for (std::size_t i = 0; i < plan.scene.objects.size(); ++i) {
    const SceneObject& object = plan.scene.objects[i];
    std::vector<Vec2> corners;
    for (const Vec3& point : outline_points(object))
      corners.push_back(place(scenery.objects[i] * point));
    const bool target = object.name == plan.movement.target;
    svg.polygon(math::convex_hull_2d(std::move(corners)),
                target ? Colours::kGoal : Colours::kObject, target ? 0.45 : 0.35);
  }
  std::vector<const DrawnCapsule*> limbs;
  for (const DrawnCapsule& limb : scenery.limbs) limbs.push_back(&limb);
  std::ranges::stable_sort(limbs, {}, [&](const DrawnCapsule* limb) {
    return view.towards_viewer.dot(limb->from + limb->to) + limb->radius;
  });
  for (const DrawnCapsule* limb : limbs) {
    const Vec2 from = place(limb->from), to = place(limb->to);
    const double width = 2 * limb->radius * frame.scale;
    svg.line(from, to, width + 1.4, "#ffffff");
    svg.line(from, to, width, limb->colour, 0.85);
  }
  for (const Vec3& goal : scenery.goals) svg.ring(place(goal), 2.4, 1.1, Colours::kGoal);
  svg.end_clip();
  const Vec2 below = corner + Vec2(kPanelWidth_px / 2, kPanelHeight_px + 14);
  svg.text(below, 12, "middle",
           fmt::format("{:.2f} s{}{}", scenery.time_s, scenery.words.empty() ? "" : ", ",
                       scenery.words));
}

/// Returns, for each row of the motion, the mean speed of the person's tips at the same
/// demonstration time.
std::vector<double> human_speed_at_rows(const std::vector<double>& demonstration_time,
                                        const Goals& goals, const std::vector<double>& speed) {
  std::vector<double> beside;
  for (const double time_s : demonstration_time)
    beside.push_back(speed[nearest_row(goals.time, time_s)]);
  return beside;
}

std::vector<double> scale_values(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

void draw_charts(Svg& svg, const Plan& plan, const PlanView& view,
                 const std::vector<PanelContent>& shown, double top) {
  const DisplayMotion* motion = goal_motion(view);
  std::vector<double> marks;
  for (const PanelContent& scenery : shown) marks.push_back(scenery.time_s);
  const std::vector<double>& time = motion ? motion->time : plan.goals.time;
  const std::vector<double>& demonstration = motion ? motion->demonstration_time : plan.goals.time;
  std::vector<ChartLine> speeds = {
      {"person", time, human_speed_at_rows(demonstration, plan.goals, view.human_speed),
       Colours::kPerson, "5 3"}};
  if (motion && !motion->mean_tip_speed.empty())
    speeds.push_back({"robot", time, motion->mean_tip_speed, Colours::kRobot, ""});
  const Vec2 size(kWidth_px / 2, kChartHeight_px);
  draw_chart(svg, {0, top}, size, "Mean fingertip speed [m/s]", speeds, marks);
  if (!motion || motion->tip_error.rows() == 0) return;
  std::vector<double> largest, allowed;
  for (Eigen::Index row = 0; row < motion->tip_error.rows(); ++row) {
    double most = kUnknown;
    for (const double error : motion->tip_error.row(row)) most = std::fmax(most, error);
    largest.push_back(most);
    const PhaseKind phase = motion->phase[row];
    const bool holds = phase == PhaseKind::grasp || phase == PhaseKind::hold;
    allowed.push_back(holds ? plan.tolerances.tracking_tolerance_grasp
                            : plan.tolerances.tracking_tolerance);
  }
  draw_chart(svg, {kWidth_px / 2, top}, size, "Largest fingertip error [mm]",
             {{"robot", time, scale_values(largest, 1e3), Colours::kRobot, ""},
              {"allowed", time, scale_values(allowed, 1e3), Colours::kFaint, "2 3"}},
             marks);
}

}  // namespace

std::string filmstrip(const robot::Robot& robot, const Plan& plan, const std::string& plan_path,
                      const PlanView& view) {
  const std::vector<PanelContent> sceneries = panel_contents(robot, plan, view);
  const Projection eye = default_projection(robot.side);
  const PanelScaling frame = fit_panel(eye, sceneries);
  const double charts = kTitleHeight_px + kPanelHeight_px + kCaptionHeight_px;
  Svg svg(kWidth_px, charts + kChartHeight_px, fmt::format("{} by {}", plan_path, robot.name));
  std::string head = fmt::format("{}, {}: {}", plan_path, robot.name, name_of(plan.status()));
  if (!plan.has_trajectory()) head += fmt::format(" ({})", name_of(plan.reason));
  svg.text({6, 18}, 14, "start", head);
  svg.text({kWidth_px - 170, 18}, 12, "end", "robot", Colours::kRobot);
  svg.text({kWidth_px - 110, 18}, 12, "end", "person", Colours::kPerson);
  svg.text({kWidth_px - 6, 18}, 12, "end", "goals, target", Colours::kGoal);
  for (std::size_t k = 0; k < sceneries.size(); ++k)
    draw_panel(svg, eye, frame, plan, sceneries[k],
               {static_cast<double>(k) * kPanelWidth_px, kTitleHeight_px});
  if (!plan.goals.time.empty()) draw_charts(svg, plan, view, sceneries, charts);
  return svg.to_string();
}

}  // namespace morphe::report
