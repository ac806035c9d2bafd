#include "pipeline/report/filmstrip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/math/convex_polygon.hpp"
#include "core/motion/goals_at.hpp"
#include "core/robot/forward.hpp"
#include "pipeline/report/film_instants.hpp"
#include "pipeline/report/outline_points.hpp"
#include "pipeline/report/svg_chart.hpp"

namespace morphe::report {
namespace {

constexpr double kWidth = 1000, kTop = 30, kPanelHeight = 230, kCaption = 34, kChartHeight = 170;
constexpr double kPanelWidth = kWidth / kFilmPoses;

/// Parallel projection of the world: right and up in the picture, near towards the eye.
struct View {
  Vec3 right, up, near;
};

/// From before the person, on the robot's side, from above, as the page's first view.
View view_from(Side side) {
  const Vec3 near = Vec3(side == Side::left ? -0.9 : 0.9, 0.75, 0.55).normalized();
  const Vec3 right = Vec3::UnitZ().cross(near).normalized();
  return {right, near.cross(right), near};
}

Vec2 projected(const View& view, const Vec3& point) {
  return {view.right.dot(point), -view.up.dot(point)};
}

/// A capsule in the world, or what a bone is drawn as.
struct Limb {
  Vec3 from, to;
  double radius;
  std::string_view colour;
};

/// What one panel shows.
struct Scenery {
  double time_s = kNotSeen, demonstration_s = kNotSeen;
  std::vector<Limb> limbs;
  std::vector<Vec3> goals;
  std::vector<Pose> objects;  ///< world_from_object, of the scene's objects
  std::string words;
};

void add_robot(const robot::Robot& robot, const Pose& world_from_base, const JointVector& q,
               std::vector<Limb>& limbs) {
  std::vector<Pose> base_from_frame;
  robot::forward(robot, q, base_from_frame);
  for (const RobotTable::Capsule& capsule : robot.capsules) {
    const Pose pose =
        capsule.frame < 0
            ? world_from_base
            : world_from_base * base_from_frame[static_cast<std::size_t>(capsule.frame)];
    limbs.push_back({pose * capsule.from, pose * capsule.to, capsule.radius, Colours::kRobot});
  }
}

void add_person(const robot::Robot& robot, const Pose& world_from_base, const Goals& goals,
                double demonstration_s, Scenery& scenery) {
  constexpr double kArm = 0.036, kFinger = 0.007;
  const auto when = goal_time(goals, demonstration_s);
  const auto seen_at = [&](const std::vector<Vec3>& points) {
    return Vec3(world_from_base * where_it_was(goals, point_at(points, when)));
  };
  const Vec3 shoulder = seen_at(goals.shoulder_position), elbow = seen_at(goals.elbow_position);
  const Vec3 wrist = seen_at(goals.wrist_position);
  const auto bone = [&](const Vec3& from, const Vec3& to, double radius) {
    if (seen(from) && seen(to)) scenery.limbs.push_back({from, to, radius, Colours::kPerson});
  };
  bone(shoulder, elbow, kArm);
  bone(elbow, wrist, 0.8 * kArm);
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const Vec3 goal = world_from_base * tip_goal_at(goals, tip, demonstration_s);
    if (!seen(goal)) continue;
    scenery.goals.push_back(goal);
    bone(wrist, goal, kFinger);
  }
}

std::vector<Pose> object_poses(const Plan& plan, const PlanView& view, const ShownMotion* motion,
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

std::vector<Scenery> sceneries_of(const robot::Robot& robot, const Plan& plan,
                                  const PlanView& view) {
  const ShownMotion* motion = goal_motion(view);
  std::vector<Scenery> sceneries;
  for (const FilmInstant& instant : film_instants(plan, view)) {
    Scenery scenery;
    scenery.time_s = instant.time_s;
    scenery.demonstration_s = instant.demonstration_s;
    scenery.words = instant.words;
    add_person(robot, view.world_from_base, plan.goals, instant.demonstration_s, scenery);
    if (motion)
      add_robot(robot, view.world_from_base,
                motion->position.row(static_cast<Eigen::Index>(instant.row)).transpose(),
                scenery.limbs);
    scenery.objects = object_poses(plan, view, motion, instant.row, instant.demonstration_s);
    sceneries.push_back(std::move(scenery));
  }
  return sceneries;
}

/// The world's place and size in a panel, the same in all.
struct Frame {
  Vec2 middle = Vec2::Zero();
  double scale = 1;  ///< [px / m]
};

Frame frame_of(const View& view, const std::vector<Scenery>& sceneries) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const auto add = [&](const Vec3& point, double radius) {
    const Vec2 at = projected(view, point);
    low = low.cwiseMin(at - Vec2::Constant(radius));
    high = high.cwiseMax(at + Vec2::Constant(radius));
  };
  for (const Scenery& scenery : sceneries) {
    for (const Limb& limb : scenery.limbs) {
      add(limb.from, limb.radius);
      add(limb.to, limb.radius);
    }
    for (const Vec3& goal : scenery.goals) add(goal, 0.02);
  }
  if (!(low.x() <= high.x())) return {Vec2::Zero(), 100};
  const Vec2 size = (high - low).cwiseMax(0.05);
  const double scale = std::min((kPanelWidth - 12) / size.x(), (kPanelHeight - 12) / size.y());
  return {(low + high) / 2, scale};
}

void draw_panel(Svg& svg, const View& view, const Frame& frame, const Plan& plan,
                const Scenery& scenery, const Vec2& corner) {
  const Vec2 centre = corner + Vec2(kPanelWidth, kPanelHeight) / 2;
  const auto place = [&](const Vec3& point) {
    return Vec2(centre + frame.scale * (projected(view, point) - frame.middle));
  };
  svg.begin_clip(corner, {kPanelWidth - 2, kPanelHeight});
  for (std::size_t i = 0; i < plan.scene.objects.size(); ++i) {
    const SceneObject& object = plan.scene.objects[i];
    std::vector<Vec2> corners;
    for (const Vec3& point : outline_points(object))
      corners.push_back(place(scenery.objects[i] * point));
    const bool target = object.name == plan.movement.target;
    svg.polygon(math::convex_polygon(std::move(corners)),
                target ? Colours::kGoal : Colours::kObject, target ? 0.45 : 0.35);
  }
  std::vector<const Limb*> limbs;
  for (const Limb& limb : scenery.limbs) limbs.push_back(&limb);
  std::ranges::stable_sort(limbs, {}, [&](const Limb* limb) {
    return view.near.dot(limb->from + limb->to) + limb->radius;
  });
  for (const Limb* limb : limbs) {
    const Vec2 from = place(limb->from), to = place(limb->to);
    const double width = 2 * limb->radius * frame.scale;
    svg.line(from, to, width + 1.4, "#ffffff");
    svg.line(from, to, width, limb->colour, 0.85);
  }
  for (const Vec3& goal : scenery.goals) svg.ring(place(goal), 2.4, 1.1, Colours::kGoal);
  svg.end_clip();
  const Vec2 below = corner + Vec2(kPanelWidth / 2, kPanelHeight + 14);
  svg.text(below, 12, "middle",
           fmt::format("{:.2f} s{}{}", scenery.time_s, scenery.words.empty() ? "" : ", ",
                       scenery.words));
}

/// At each row of the motion the mean speed of the person's tips, at the same demonstration time.
std::vector<double> speed_beside(const std::vector<double>& demonstration_time, const Goals& goals,
                                 const std::vector<double>& speed) {
  std::vector<double> beside;
  for (const double time_s : demonstration_time)
    beside.push_back(speed[row_near(goals.time, time_s)]);
  return beside;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

void draw_charts(Svg& svg, const Plan& plan, const PlanView& view,
                 const std::vector<Scenery>& shown, double top) {
  const ShownMotion* motion = goal_motion(view);
  std::vector<double> marks;
  for (const Scenery& scenery : shown) marks.push_back(scenery.time_s);
  const std::vector<double>& time = motion ? motion->time : plan.goals.time;
  const std::vector<double>& demonstration = motion ? motion->demonstration_time : plan.goals.time;
  std::vector<ChartLine> speeds = {{"person", time,
                                    speed_beside(demonstration, plan.goals, view.human_speed),
                                    Colours::kPerson, "5 3"}};
  if (motion && !motion->speed.empty())
    speeds.push_back({"robot", time, motion->speed, Colours::kRobot, ""});
  const Vec2 size(kWidth / 2, kChartHeight);
  draw_chart(svg, {0, top}, size, "Speed of the fingertips, mean [m/s]", speeds, marks);
  if (!motion || motion->tip_error.rows() == 0) return;
  std::vector<double> largest, allowed;
  for (Eigen::Index row = 0; row < motion->tip_error.rows(); ++row) {
    double most = kNotSeen;
    for (const double error : motion->tip_error.row(row)) most = std::fmax(most, error);
    largest.push_back(most);
    const PhaseKind phase = motion->phase[static_cast<std::size_t>(row)];
    const bool holds = phase == PhaseKind::grasp || phase == PhaseKind::hold;
    allowed.push_back(holds ? plan.tolerances.tracking_grasp : plan.tolerances.tracking);
  }
  draw_chart(svg, {kWidth / 2, top}, size, "Fingertips from their goals, largest [mm]",
             {{"robot", time, scaled(largest, 1e3), Colours::kRobot, ""},
              {"allowed", time, scaled(allowed, 1e3), Colours::kFaint, "2 3"}},
             marks);
}

}  // namespace

std::string filmstrip(const robot::Robot& robot, const Plan& plan, const std::string& plan_path,
                      const PlanView& view) {
  const std::vector<Scenery> sceneries = sceneries_of(robot, plan, view);
  const View eye = view_from(robot.side);
  const Frame frame = frame_of(eye, sceneries);
  const double charts = kTop + kPanelHeight + kCaption;
  Svg svg(kWidth, charts + kChartHeight, fmt::format("{} by {}", plan_path, robot.name));
  std::string head = fmt::format("{}, {}: {}", plan_path, robot.name, name_of(plan.status()));
  if (!plan.has_trajectory()) head += fmt::format(" ({})", name_of(plan.reason));
  svg.text({6, 18}, 14, "start", head);
  svg.text({kWidth - 170, 18}, 12, "end", "robot", Colours::kRobot);
  svg.text({kWidth - 110, 18}, 12, "end", "person", Colours::kPerson);
  svg.text({kWidth - 6, 18}, 12, "end", "goals, target", Colours::kGoal);
  for (std::size_t k = 0; k < sceneries.size(); ++k)
    draw_panel(svg, eye, frame, plan, sceneries[k], {static_cast<double>(k) * kPanelWidth, kTop});
  if (!plan.goals.time.empty()) draw_charts(svg, plan, view, sceneries, charts);
  return svg.finished();
}

}  // namespace morphe::report
