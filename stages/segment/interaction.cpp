#include "stages/segment/interaction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/motion/bounding_box.hpp"

namespace morphe::segment {
namespace {

/// Largest distance of hand and object that move together [m].
constexpr double kMaxHandDistance_m = 0.1;
constexpr double kHandLength_m = 0.18;        ///< from the wrist to the fingertips [m]
constexpr double kMotionHalfWindow_s = 0.1;   ///< on either side
constexpr double kMaxSlipShare = 0.5;         ///< share of the displacement
constexpr double kMinDisplacement_m = 0.002;  ///< in twice kMotionHalfWindow_s [m]
constexpr double kMaxHeldWidth_m = 0.15;      ///< [m]
constexpr double kMaxTipGap_m = 0.05;         ///< gap to the surface, both tips together [m]
constexpr double kMinCommonMotion_s = 0.1, kOnsetTolerance_s = 0.2;

/// Returns true if a box is between two fingertips that hold it. All points are in the box's frame.
bool is_between_tips(const Eigen::AlignedBox3d& box, const Vec3& thumb, const Vec3& finger) {
  const double apart = (finger - thumb).norm();
  if (!(apart > 0) || box.isEmpty() || box.sizes().isZero()) return false;
  const Vec3 along = (finger - thumb) / apart;
  double enters = -kInfinity, leaves = kInfinity;  // along the line, 0 at the thumb
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (along[k] == 0) {
      if (thumb[k] < box.min()[k] || thumb[k] > box.max()[k]) return false;
      continue;
    }
    const double one = (box.min()[k] - thumb[k]) / along[k];
    const double other = (box.max()[k] - thumb[k]) / along[k];
    enters = std::max(enters, std::min(one, other));
    leaves = std::min(leaves, std::max(one, other));
  }
  if (leaves < enters || leaves - enters > kMaxHeldWidth_m) return false;
  const double inside = std::min(leaves, apart) - std::max(enters, 0.0);
  return inside > 0 && apart - inside < kMaxTipGap_m;
}

bool moves_rigidly_with(const Pose& before, const Pose& after, const Vec3& from, const Vec3& to) {
  const Vec3 would_go = after * (before.inverse() * from) - from;
  const double way = would_go.norm();
  return way > kMinDisplacement_m && (to - from - would_go).norm() < kMaxSlipShare * way;
}

HandObjectInteraction interaction_with(const SceneObject& object, const HumanMotion& motion,
                                       const HandSignals& signals) {
  const std::size_t n = signals.frames();
  const bool has_tips = motion.tip.rows == n && motion.tip.cols == kFingerCount;
  const Eigen::AlignedBox3d box = bounding_box(object, Pose::Identity());
  HandObjectInteraction interaction{object.name, std::vector<double>(n, kUnknown),
                                    std::vector<bool>(n), std::vector<bool>(n)};
  std::vector<Pose> world_from_object(n);
  for (std::size_t i = 0; i < n; ++i) {
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
  const auto look =
      static_cast<std::size_t>(std::max(1.0, std::round(kMotionHalfWindow_s / signals.step_s)));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = i > look ? i - look : 0, b = std::min(i + look, n - 1);
    interaction.moves_with_hand[i] = moves_rigidly_with(world_from_object[a], world_from_object[b],
                                                        signals.wrist[a], signals.wrist[b]) ||
                                     moves_rigidly_with(world_from_object[a], world_from_object[b],
                                                        signals.position[a], signals.position[b]);
  }
  return interaction;
}

/// The part of an object motion that the hand caused and its distance from the fingertips.
struct HandCausedMotion {
  ObjectMotion motion;
  double distance = 0;  ///< mean distance [m]
};

/// Clips a motion to the part that the hand caused; its displacement is 0 if the hand did not cause
/// it.
HandCausedMotion clip_to_hand_motion(ObjectMotion motion, const HandObjectInteraction& contact,
                                     const HandSignals& signals) {
  const std::size_t begin = signals.frame(motion.begin_s), end = signals.frame(motion.end_s);
  std::size_t first = end, last = begin, count = 0;
  double distance = 0;
  for (std::size_t i = begin; i <= end; ++i) {
    if (!contact.moves_with_hand[i] || !(contact.distance[i] < kMaxHandDistance_m)) continue;
    if (count == 0) first = i;
    last = i;
    ++count;
    distance += contact.distance[i];
  }
  const double with_s = static_cast<double>(count) * signals.step_s;
  if (count == 0 || with_s < std::min(kMinCommonMotion_s, (motion.end_s - motion.begin_s) / 2)) {
    motion.displacement_m = 0;
    return {motion, 0};
  }
  const double first_s = signals.time(static_cast<double>(first));
  const double last_s = signals.time(static_cast<double>(last));
  if (first_s > motion.begin_s + kOnsetTolerance_s) motion.begin_s = first_s;
  if (last_s < motion.end_s - kOnsetTolerance_s) motion.end_s = last_s;
  return {motion, distance / static_cast<double>(count)};
}

bool overlap_in_time(const ObjectMotion& a, const ObjectMotion& b) {
  const double common = std::min(a.end_s, b.end_s) - std::max(a.begin_s, b.begin_s);
  return common > 0.5 * std::min(a.end_s - a.begin_s, b.end_s - b.begin_s);
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
                                          const std::vector<HandObjectInteraction>& contacts,
                                          const HandSignals& signals) {
  std::vector<HandCausedMotion> made;
  for (const ObjectMotion& motion : motions) {
    const auto interaction =
        std::ranges::find(contacts, motion.object, &HandObjectInteraction::object);
    if (interaction == contacts.end()) continue;
    HandCausedMotion one = clip_to_hand_motion(motion, *interaction, signals);
    if (one.motion.displacement_m > 0) made.push_back(std::move(one));
  }
  std::vector<ObjectMotion> result;
  for (const HandCausedMotion& one : made) {
    const bool farther = std::ranges::any_of(made, [&](const HandCausedMotion& other) {
      return other.motion.object != one.motion.object &&
             overlap_in_time(other.motion, one.motion) && other.distance < one.distance;
    });
    if (!farther) result.push_back(one.motion);
  }
  std::ranges::stable_sort(result, {}, &ObjectMotion::begin_s);
  return result;
}

std::string longest_held_object(const std::vector<HandObjectInteraction>& contacts,
                                const HandSignals& signals, double from_s, double to_s,
                                double least_s) {
  std::string object;
  double longest_s = least_s;
  for (const HandObjectInteraction& interaction : contacts) {
    std::size_t count = 0;
    for (std::size_t i = signals.frame(from_s); i <= signals.frame(to_s); ++i) {
      count += interaction.between_tips[i] ? 1 : 0;
    }
    const double held_s = static_cast<double>(count) * signals.step_s;
    if (count == 0 || held_s < longest_s || (held_s == longest_s && !object.empty())) continue;
    longest_s = held_s;
    object = interaction.object;
  }
  return object;
}

}  // namespace morphe::segment
