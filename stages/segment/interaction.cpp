#include "stages/segment/interaction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/motion/bounding_box.hpp"

namespace morphe::segment {
namespace {

/// Returns true if a box is between two fingertips that hold it. All points are in the box's frame.
bool is_between_tips(const Eigen::AlignedBox3d& box, const Vec3& thumb, const Vec3& finger) {
  const double aperture = (finger - thumb).norm();
  if (!(aperture > 0) || box.isEmpty() || box.sizes().isZero()) return false;
  const Vec3 along = (finger - thumb) / aperture;
  double enters = -kInfinity, leaves = kInfinity;  // distances from the thumb along the line
  for (int k = 0; k < 3; ++k) {
    if (along[k] == 0) {
      if (thumb[k] < box.min()[k] || thumb[k] > box.max()[k]) return false;
      continue;
    }
    const double to_min = (box.min()[k] - thumb[k]) / along[k];
    const double to_max = (box.max()[k] - thumb[k]) / along[k];
    enters = std::max(enters, std::min(to_min, to_max));
    leaves = std::min(leaves, std::max(to_min, to_max));
  }
  if (leaves < enters || leaves - enters > kMaxHeldWidth_m) return false;
  const double inside = std::min(leaves, aperture) - std::max(enters, 0.0);
  return inside > 0 && aperture - inside < kMaxTipGap_m;
}

/// Returns true if a point of the hand moves between two instants as if it were fixed to the
/// object.
bool moves_rigidly_with(const Pose& before, const Pose& after, const Vec3& from, const Vec3& to) {
  const Vec3 rigid = after * (before.inverse() * from) - from;
  const double displacement_m = rigid.norm();
  return displacement_m > kMinDisplacement_m &&
         (to - from - rigid).norm() < kMaxSlipShare * displacement_m;
}

HandObjectInteraction interaction_with(const SceneObject& object, const HumanMotion& motion,
                                       const HandSignals& signals) {
  const std::size_t n = motion.time.size();
  const bool has_tips = motion.tip.rows == n && motion.tip.cols == kFingerCount;
  const Eigen::AlignedBox3d box = bounding_box(object, Pose::Identity());
  HandObjectInteraction interaction{object.name, std::vector<double>(n, kUnknown),
                                    std::vector<bool>(n), std::vector<bool>(n)};
  std::vector<Pose> world_from_object(n);
  for (int i = 0; i < signals.frames(); ++i) {
    world_from_object[i] = recorded_pose(object, motion.time[i]);
    const Pose object_from_world = world_from_object[i].inverse();
    std::array<Vec3, kFingerCount> tip;
    for (std::size_t finger = 0; has_tips && finger < kFingerCount; ++finger) {
      tip[finger] = object_from_world * motion.tip(i, finger);
      if (!is_known(tip[finger])) continue;
      interaction.distance[i] =
          std::fmin(interaction.distance[i], box.exteriorDistance(tip[finger]));
      if (finger == kThumb || !is_known(tip[kThumb])) continue;
      interaction.between_tips[i] =
          interaction.between_tips[i] || is_between_tips(box, tip[kThumb], tip[finger]);
    }
    const Vec3 wrist = object_from_world * motion.wrist[i];
    if (!std::isnan(interaction.distance[i]) || !is_known(wrist)) continue;
    interaction.distance[i] = std::max(0.0, box.exteriorDistance(wrist) - kHandLength_m);
  }
  if (object.time.size() < 2) return interaction;
  const long half_window = std::max(1L, std::lround(kMotionHalfWindow_s / signals.step_s));
  const long last = signals.frames() - 1;
  for (int i = 0; i < signals.frames(); ++i) {
    const long a = std::max(i - half_window, 0L), b = std::min(i + half_window, last);
    interaction.moves_with_hand[i] = moves_rigidly_with(world_from_object[a], world_from_object[b],
                                                        signals.wrist[a], signals.wrist[b]) ||
                                     moves_rigidly_with(world_from_object[a], world_from_object[b],
                                                        signals.position[a], signals.position[b]);
  }
  return interaction;
}

/// The part of an object motion that the hand caused; without one, displacement_m is 0.
struct HandCausedMotion {
  ObjectMotion motion;
  double distance = 0;  ///< mean distance of the object from the fingertips [m]
};

/// Clips a motion to the part that the hand caused.
HandCausedMotion clip_to_hand_motion(ObjectMotion motion, const HandObjectInteraction& hand,
                                     const HandSignals& signals) {
  const int end = signals.frame(motion.end_s);
  int first = 0, last = 0, count = 0;
  double distance = 0;
  for (int i = signals.frame(motion.begin_s); i <= end; ++i) {
    if (!hand.moves_with_hand[i] || !(hand.distance[i] < kMaxHandDistance_m)) continue;
    if (count == 0) first = i;
    last = i;
    ++count;
    distance += hand.distance[i];
  }
  const double common_s = count * signals.step_s;
  if (count == 0 || common_s < std::min(kMinCommonMotion_s, (motion.end_s - motion.begin_s) / 2)) {
    motion.displacement_m = 0;
    return {motion, 0};
  }
  const double first_s = signals.time(first), last_s = signals.time(last);
  if (first_s > motion.begin_s + kOnsetTolerance_s) motion.begin_s = first_s;
  if (last_s < motion.end_s - kOnsetTolerance_s) motion.end_s = last_s;
  return {motion, distance / count};
}

}  // namespace

std::vector<HandObjectInteraction> find_interactions(const HumanMotion& motion,
                                                     const HandSignals& signals,
                                                     const std::vector<SceneObject>& objects) {
  std::vector<HandObjectInteraction> interactions;
  if (signals.frames() == 0) return interactions;
  for (const SceneObject& object : objects) {
    if (!object.time.empty()) interactions.push_back(interaction_with(object, motion, signals));
  }
  return interactions;
}

std::vector<ObjectMotion> motions_by_hand(const std::vector<ObjectMotion>& motions,
                                          const std::vector<HandObjectInteraction>& interactions,
                                          const HandSignals& signals) {
  std::vector<HandCausedMotion> caused;
  for (const ObjectMotion& motion : motions) {
    const auto interaction =
        std::ranges::find(interactions, motion.object, &HandObjectInteraction::object);
    if (interaction == interactions.end()) continue;
    HandCausedMotion part = clip_to_hand_motion(motion, *interaction, signals);
    if (part.motion.displacement_m > 0) caused.push_back(std::move(part));
  }
  std::vector<ObjectMotion> result;
  for (const HandCausedMotion& one : caused) {
    const bool farther = std::ranges::any_of(caused, [&](const HandCausedMotion& other) {
      return other.motion.object != one.motion.object &&
             overlap_in_time(other.motion, one.motion) && other.distance < one.distance;
    });
    if (!farther) result.push_back(one.motion);
  }
  std::ranges::stable_sort(result, {}, &ObjectMotion::begin_s);
  return result;
}

std::string longest_held_object(const std::vector<HandObjectInteraction>& interactions,
                                const HandSignals& signals, double from_s, double to_s,
                                double min_held_s) {
  std::string object;
  double longest_s = min_held_s;
  for (const HandObjectInteraction& interaction : interactions) {
    const auto held = interaction.between_tips.begin();
    const auto count =
        std::count(held + signals.frame(from_s), held + signals.frame(to_s) + 1, true);
    const double held_s = static_cast<double>(count) * signals.step_s;
    if (count == 0 || held_s < longest_s || (held_s == longest_s && !object.empty())) continue;
    longest_s = held_s;
    object = interaction.object;
  }
  return object;
}

}  // namespace morphe::segment
