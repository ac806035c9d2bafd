#include "pipeline/planning/plan_sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/collision/mesh_solid.hpp"
#include "core/motion/arm_estimate.hpp"
#include "core/robot/opening.hpp"
#include "stages/grasp/carrying.hpp"

namespace morphe::planning {
namespace {

/// Returns a sentence on the delay against the demonstration's timing.
std::string delay_text(const Trajectory& trajectory) {
  constexpr double kOnTime_s = 0.01;
  double max_delay_s = 0, delayed_s = 0;
  for (std::size_t i = 1; i < trajectory.samples(); ++i) {
    const double delay_s = trajectory.time[i] - trajectory.time[0] -
                           (trajectory.demonstration_time[i] - trajectory.demonstration_time[0]);
    max_delay_s = std::max(max_delay_s, delay_s);
    if (delay_s > kOnTime_s) delayed_s += trajectory.time[i] - trajectory.time[i - 1];
  }
  return fmt::format(
      "behind the demonstration by up to {:.2f} s (by more than {:.2f} s during {:.2f} s)",
      max_delay_s, kOnTime_s, delayed_s);
}

}  // namespace

std::string join_sentences(const std::vector<std::string>& sentences) {
  return fmt::format("{}", fmt::join(sentences, "; "));
}

std::string warnings(const collision::CollisionWorld& world, const Goals& goals,
                     const Movement& movement, const HumanMotion& motion,
                     const Trajectory& trajectory, bool with_delay) {
  constexpr double kMaxUncertainConfidence = 0.5;
  const robot::Robot& robot = *world.robot;
  std::vector<std::string> sentences, goal_tips;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    std::size_t count = 0;
    if (!goals.auto_closed.empty() && goals.auto_closed[tip] != 0) continue;
    for (std::size_t f = 0; f < goals.frames(); ++f) count += is_known(goals.tip_position(f, tip));
    if (count > 0) goal_tips.push_back(robot.tips[tip].name);
    if (count > 0 && count < goals.frames()) {
      sentences.push_back(fmt::format("{} has a goal in {} of {} frames", robot.tips[tip].name,
                                      count, goals.frames()));
    }
  }
  if (goals.hand_scale != 1) {
    sentences.push_back(fmt::format("the person's hand is scaled by {:.3g}", goals.hand_scale));
  }
  if (goals.base_offset) {
    const Vec3 moved = 1e3 * *goals.base_offset;
    sentences.push_back(fmt::format("the base is moved by ({:.0f}, {:.0f}, {:.0f}) mm", moved.x(),
                                    moved.y(), moved.z()));
  }
  for (std::size_t k = 0; k < world.meshes.size(); ++k) {
    if (world.meshes[k] && collision::is_open(*world.meshes[k])) {
      sentences.push_back(world.scene->objects[k].name +
                          " is not a closed mesh: only its surface is an obstacle");
    }
  }
  if (with_delay && !trajectory.time.empty()) sentences.push_back(delay_text(trajectory));
  if (goal_tips.size() == 1) sentences.push_back("only " + goal_tips.front() + " has goals");
  for (const Phase& phase : movement.phases) {
    if (main_phase_of(phase.kind) != phase.kind) continue;  // has the limits of its main phase
    if (phase.begin_s > movement.end_s || phase.confidence > kMaxUncertainConfidence) continue;
    sentences.push_back(fmt::format("the limits of phase {} are uncertain (confidence {:.0f} %)",
                                    name_of(phase.kind), 100 * phase.confidence));
  }
  sentences.insert(sentences.end(), motion.reconstruction_notes.begin(),
                   motion.reconstruction_notes.end());
  return join_sentences(sentences);
}

std::string opening_warning(const RobotModel& robot, const Goals& goals) {
  constexpr double kNoticed_m = 0.001;
  std::array<std::ptrdiff_t, 2> tips = {-1, -1};
  for (std::ptrdiff_t tip = 0; tip < std::ssize(robot.tips); ++tip)
    if (const int finger = robot.tips[tip].finger; finger == 0 || finger == 1) tips[finger] = tip;
  if (tips[0] < 0 || tips[1] < 0 || goals.tip_position.cols < robot.tips.size()) return "";
  double asked_m = 0;
  for (std::size_t f = 0; f < goals.frames(); ++f) {
    const double apart_m = (goals.tip_position(f, tips[0]) - goals.tip_position(f, tips[1])).norm();
    if (apart_m > asked_m) asked_m = apart_m;  // false where a goal is unknown
  }
  if (asked_m == 0) return "";
  const double widest_m = robot::widest_opening(robot, asked_m);
  if (asked_m <= widest_m + kNoticed_m) return "";
  return fmt::format(
      "thumb and index open {:.0f} mm in the recording, the robot's no more than {:.0f} mm "
      "(between "
      "the tips)",
      1e3 * asked_m, 1e3 * widest_m);
}

std::string grasp_force_warning(const Grasp& grasp) {
  const bool judged = !std::isnan(grasp.quality.epsilon_upper);
  if (!judged || grasp.grasp_torque.size() > 0) return "";
  return fmt::format("no squeeze: no forces at these contacts are in balance (epsilon {:.2f})",
                     grasp.quality.epsilon_upper);
}

std::string near_contacts_warning(const Grasp& grasp) {
  std::vector<std::string> sentences;
  for (const PadContact& contact : grasp.contacts) {
    if (contact.state == ContactState::touching) continue;
    sentences.push_back(
        fmt::format("{} is only near the target (gap {:.1f} mm, pad {:.0f} degrees "
                    "off) and counts as no contact",
                    contact.tip, 1e3 * contact.signed_distance, contact.pad_angle / kRadPerDegree));
  }
  return join_sentences(sentences);
}

std::string unchecked_carrying_warning(const Movement& movement) {
  const double begin_s = carrying_begin_s(movement);
  if (std::isnan(begin_s)) return "";
  return fmt::format(
      "{} is carried from {:.2f} s on, but its contacts are not planned or checked (add the "
      "section "
      "`grasp` to the config)",
      movement.target, begin_s);
}

std::string humanlikeness_warning(const Certificate& certificate, const Goals& goals) {
  constexpr double kMaxUpperArmError_rad = 45 * kRadPerDegree;
  if (!(certificate.upper_arm_error_mean > kMaxUpperArmError_rad)) return "";
  return fmt::format(
      "not humanlike: the upper arm deviates from the person's{2} by {0}{1:.0f} degrees on average "
      "(try morphe place)",
      is_arm_estimated(goals) ? "~" : "", certificate.upper_arm_error_mean / kRadPerDegree,
      is_arm_estimated(goals) ? ", which is estimated," : "");
}

}  // namespace morphe::planning
