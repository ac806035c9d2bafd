#include "pipeline/setup/gripper_pads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/input_error.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/closing.hpp"
#include "pipeline/setup/pad_surface.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

constexpr double kTouching_m = 0.0005;  ///< gap from which on pads count as touching

/// Two jaws, and what is known of them in all postures.
struct Jaws {
  const Kinematics& robot;
  const Hand& hand;
  const BodyPoints& points;
  std::array<BodyPoint, 2> middles;  ///< of their bodies
  int tool_point = -1;               ///< frame between their tips, -1 if the file has none

  int moving_frame(int k) const {
    return robot::moving_frame_of(robot.table(), hand.fingers[k].body);
  }
};

/// The jaws in one posture, in the base frame.
struct View {
  std::vector<Pose> poses;
  Vec3 normal = Vec3::UnitX();   ///< from the thumb's jaw to the other
  Vec3 forward = Vec3::UnitZ();  ///< in which both point
  Vec3 from = Vec3::Zero();      ///< from which `forward` is measured
  std::array<Vec3, 2> pads = {Vec3::Zero(), Vec3::Zero()};

  double gap_m() const { return (pads[1] - pads[0]).dot(normal); }
};

/// Returns the middles of both jaws; of a fixed one its end, since its body is also the palm, and
/// then the end of the moving one, too.
std::array<BodyPoint, 2> middles_of(const Kinematics& robot, const Hand& hand,
                                    const BodyPoints& points) {
  const Finger &thumb = hand.fingers[0], &index = hand.fingers[1];
  if (!hand.has_fixed_jaw())
    return {body_middle(robot, thumb, points), body_middle(robot, index, points)};
  const Vec3 joint = robot.pose(thumb.frames.back()).translation();
  const auto sure = points.contains(index.body) ? Provenance::derived : Provenance::read;
  return {body_end(robot, thumb, points, joint), BodyPoint{index.body, hand.fixed_jaw_end, sure}};
}

/// Returns the farthest frame without shapes that is fixed to the palm and named as a tool centre
/// point, -1 without one.
int find_tool_point(const Kinematics& robot, const Hand& hand, const BodyPoints& points) {
  constexpr std::array<std::string_view, 5> kWords = {"tcp", "tool", "grasp", "tip",
                                                      "gripper_frame"};
  const int palm = robot::moving_frame_of(robot.table(), hand.root);
  int best = -1;
  double farthest_m = 1e-3;
  for (int f = 0; f < std::ssize(robot.table().frames); ++f) {
    if (points.contains(f) || robot.moves(f)) continue;
    if (robot::moving_frame_of(robot.table(), f) != palm) continue;
    if (!robot::is_in_subtree(robot.table(), f, hand.root)) continue;
    const std::string name = lower_case(robot.link[f]);
    const auto named = [&](std::string_view word) { return name.find(word) != std::string::npos; };
    const double far_m = (robot.pose(f).translation() - robot.pose(hand.root).translation()).norm();
    if (far_m < farthest_m || std::ranges::none_of(kWords, named)) continue;
    best = f;
    farthest_m = far_m;
  }
  return best;
}

/// Returns the direction in which the jaws point: perpendicular to the closing direction, from the
/// palm to their middles; of a jaw that swings beside a fixed one, also perpendicular to its axis.
Vec3 forward_of(const Jaws& jaws, const View& view) {
  const Vec3 middle = 0.5 * (jaws.middles[0].at(view.poses) + jaws.middles[1].at(view.poses));
  Vec3 forward = perpendicular_part(middle - view.from, view.normal);
  const int last = jaws.hand.fingers[0].frames.back();
  if (jaws.hand.has_fixed_jaw() && !jaws.robot.frame(last).prismatic) {
    const Vec3 axis = view.poses[last].linear() * jaws.robot.frame(last).axis;
    forward = perpendicular_part(forward, axis);
  }
  if (forward.norm() < 1e-3)
    forward = perpendicular_part(view.poses[jaws.hand.root].linear().col(2), view.normal);
  return forward.normalized();
}

/// Returns how far the jaws' ends are in front of view.from without shapes, and how sure that is.
std::pair<double, Provenance> reach_without_shapes(const Jaws& jaws, const View& view) {
  const auto reach = [&](const Vec3& point) { return (point - view.from).dot(view.forward); };
  std::array<double, 2> reach_m = {0, 0};
  Provenance sure = Provenance::read;
  for (const int k : {0, 1}) {
    const BodyPoint& middle = jaws.middles[k];
    if (middle.sure == Provenance::assumed) sure = Provenance::assumed;
    const double joint_m = reach(view.poses[middle.frame].translation());
    const double factor = middle.sure == Provenance::assumed ? 2 : 1;  // of a centre of mass
    reach_m[k] = joint_m + factor * (reach(middle.at(view.poses)) - joint_m);
  }
  if (sure == Provenance::assumed && jaws.tool_point >= 0)
    return {reach(view.poses[jaws.tool_point].translation()), Provenance::read};
  return {std::min(reach_m[0], reach_m[1]), sure};
}

/// Sets the pads where they meet: between the middles, or at the tool centre point of a fixed jaw.
void set_pads_without_shapes(const Jaws& jaws, View& view) {
  Vec3 between = 0.5 * (jaws.middles[0].at(view.poses) + jaws.middles[1].at(view.poses));
  if (jaws.hand.has_fixed_jaw() && jaws.tool_point >= 0)
    between = view.poses[jaws.tool_point].translation();
  const double reach_m = reach_without_shapes(jaws, view).first;
  view.pads.fill(between + (reach_m - (between - view.from).dot(view.forward)) * view.forward);
}

/// Returns the jaws at one of the postures, moving as from the posture before it or to that after.
View view_at(const Jaws& jaws, const std::vector<JointVector>& postures, std::size_t i) {
  View view;
  std::vector<Pose> other;
  const std::size_t beside = i > 0 ? i - 1 : 1;
  robot::forward_kinematics(jaws.robot.table(), postures[i], view.poses);
  robot::forward_kinematics(jaws.robot.table(), postures[beside], other);
  const auto apart = [&](const std::vector<Pose>& poses) -> Vec3 {
    return jaws.middles[0].at(poses) - jaws.middles[1].at(poses);
  };
  view.normal = ((i > 0 ? 1 : -1) * (apart(view.poses) - apart(other))).normalized();
  view.from = view.poses[jaws.hand.root].translation();
  view.forward = forward_of(jaws, view);
  std::array<std::vector<Vec3>, 2> bodies;
  for (const int k : {0, 1})
    bodies[k] = body_points(jaws.robot, jaws.moving_frame(k), jaws.points, view.poses);
  if (bodies[0].empty() || bodies[1].empty()) {
    set_pads_without_shapes(jaws, view);
    return view;
  }
  const double end_m = std::min(end_along(bodies[0], view.from, view.forward),
                                end_along(bodies[1], view.from, view.forward));
  for (const int k : {0, 1})
    view.pads[k] = pad_surface(bodies[k], view.from, view.forward,
                               k == 0 ? view.normal : Vec3(-view.normal), end_m);
  return view;
}

/// Returns the jaws where they touch, or at the closed end of their range.
View closed_view(const Jaws& jaws, const std::vector<JointVector>& postures) {
  View view = view_at(jaws, postures, 0);
  if (view.gap_m() <= kTouching_m) return view_at(jaws, postures, postures.size() - 1);
  for (std::size_t i = 1; i < postures.size() && view.gap_m() > kTouching_m; ++i)
    view = view_at(jaws, postures, i);
  return view;
}

std::vector<JointVector> closing_of(const Jaws& jaws) {
  const auto& fingers = jaws.hand.fingers;
  auto postures = closing_postures(jaws.robot, fingers, jaws.middles);
  if (postures) return std::move(*postures);
  const std::string joint =
      jaws.robot.table().joint_names[jaws.robot.frame(fingers[0].frames.back()).joint];
  throw InputError(fmt::format(
      "{}: neither shapes nor limits tell how the jaws {} and {} close: give the range of their "
      "joint from closed to open with --limit {}=LOWER..UPPER, or their meshes with --package "
      "NAME=DIR",
      jaws.robot.model->file.string(), jaws.robot.link[fingers[0].body],
      jaws.robot.link[fingers[1].body], joint));
}

Jaws jaws_of(const Kinematics& robot, const Hand& hand, const BodyPoints& points) {
  return {robot, hand, points, middles_of(robot, hand, points),
          find_tool_point(robot, hand, points)};
}

}  // namespace

std::vector<Pad> gripper_pads(const Kinematics& robot, const Hand& hand, const BodyPoints& points) {
  const Jaws jaws = jaws_of(robot, hand, points);
  const View view = closed_view(jaws, closing_of(jaws));
  const bool measured =
      jaws.middles[0].sure == Provenance::derived && jaws.middles[1].sure == Provenance::derived;
  std::vector<Pad> pads;
  for (const int k : {0, 1}) {
    Pad pad;
    pad.frame = hand.fingers[k].body;
    const Pose frame_from_base = view.poses[pad.frame].inverse();
    const int own_tip = find_urdf_tip(robot, pad.frame, points);
    const int tip = own_tip >= 0 && !hand.fingers[k].frames.empty() ? own_tip : jaws.tool_point;
    if (tip >= 0) {
      pad.urdf_tip_link = robot.link[tip];
      pad.urdf_tip = frame_from_base * view.poses[tip].translation();
    }
    pad.assumed_to_meet = !measured;
    pad.sure = measured ? Provenance::derived : reach_without_shapes(jaws, view).second;
    const Vec3 normal = k == 0 ? view.normal : Vec3(-view.normal);
    pad.frame_from_pad = frame_from_base * make_frame(view.pads[k], normal, view.forward);
    pads.push_back(pad);
  }
  return pads;
}

double gripper_opening(const Kinematics& robot, const Hand& hand, const std::vector<Pad>& pads) {
  const std::array<BodyPoint, 2> surfaces = {
      BodyPoint{pads[0].frame, pads[0].frame_from_pad.translation(), Provenance::derived},
      BodyPoint{pads[1].frame, pads[1].frame_from_pad.translation(), Provenance::derived}};
  double widest_m = 0;
  if (const auto postures = closing_postures(robot, hand.fingers, surfaces)) {
    for (const JointVector& q : *postures) {
      std::vector<Pose> poses;
      robot::forward_kinematics(robot.table(), q, poses);
      widest_m = std::max(widest_m, (surfaces[0].at(poses) - surfaces[1].at(poses)).norm());
    }
  }
  return widest_m;
}

}  // namespace morphe::setup
