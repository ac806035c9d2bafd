#include "stages/reconstruct/estimated_arm.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/statistics.hpp"
#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

// Shares of the stature: Drillis and Contini 1966, and as estimate_arm() says.
constexpr double kHandLengthShare = 0.108;
constexpr double kShoulderBelowHeadShare = 0.115, kShoulderAsideHeadShare = 0.109;

/// Returns the shoulder that the head or, if unseen, the first wrist suggests; unseen without both.
Vec3 initial_shoulder(const human::ArmLengths& lengths, const HumanOptions& human,
                      const std::vector<Vec3>& head, const std::vector<Vec3>& wrist) {
  const Vec3 median_head = math::median_point(head);
  if (is_known(median_head)) {
    const double stature_m = lengths.upper_arm / human::arm_lengths_of_stature(1).upper_arm;
    return median_head + stature_m * Vec3(kShoulderAsideHeadShare, 0, -kShoulderBelowHeadShare);
  }
  const auto first = std::ranges::find_if(wrist, [](const Vec3& point) { return is_known(point); });
  return first == wrist.end() ? unknown_point() : Vec3(*first + human.shoulder_from_first_wrist);
}

void estimate_shoulder(const human::ArmLengths& lengths, const HumanOptions& human,
                       const std::vector<Vec3>& head, HumanMotion& motion) {
  const Vec3 initial = initial_shoulder(lengths, human, head, motion.wrist);
  if (!is_known(initial)) return;
  const double max_m = human.max_reach_share * (lengths.upper_arm + lengths.forearm);
  const std::optional<Vec3> shoulder = human::shoulder_within_reach(initial, motion.wrist, max_m);
  if (!shoulder) {
    motion.reconstruction_notes.push_back(fmt::format(
        "no fixed shoulder position has all wrist positions within {:.0f} mm: no arm is estimated",
        kMillimetresPerMetre * max_m));
    return;
  }
  std::ranges::fill(motion.shoulder, *shoulder);
  motion.estimated.push_back("shoulder");
  motion.reconstruction_notes.push_back(
      "the shoulder was not recorded: it is estimated (error usually below 65 mm); humanlikeness "
      "of the arm is relative to an estimate");
}

}  // namespace

human::ArmLengths arm_lengths_of(const Demonstration& demonstration, const HumanOptions& human,
                                 const std::optional<double>& hand_length) {
  const double stature_m = human.stature_m ? *human.stature_m
                           : hand_length   ? *hand_length / kHandLengthShare
                                           : kDefaultStature_m;
  human::ArmLengths lengths = human::arm_lengths_of_stature(stature_m);
  if (human.upper_arm) lengths.upper_arm = *human.upper_arm;
  if (human.forearm) lengths.forearm = *human.forearm;
  if (demonstration.upper_arm) lengths.upper_arm = *demonstration.upper_arm;
  if (demonstration.forearm) lengths.forearm = *demonstration.forearm;
  return lengths;
}

void estimate_arm(const human::ArmLengths& lengths, const HumanOptions& human,
                  const std::vector<Vec3>& head, HumanMotion& motion) {
  if (never_seen(motion.wrist)) return;
  if (never_seen(motion.shoulder)) estimate_shoulder(lengths, human, head, motion);
  if (never_seen(motion.shoulder)) return;
  if (!never_seen(motion.elbow)) return;
  for (int i = 0; i < std::ssize(motion.elbow); ++i) {
    motion.elbow[i] =
        human::elbow_from_swivel(motion.shoulder[i], motion.wrist[i], lengths, human.elbow_swivel);
  }
  motion.estimated.push_back("elbow");
  motion.reconstruction_notes.push_back(
      "the elbow was not recorded: it is estimated from shoulder, wrist and human.elbow_swivel");
}

}  // namespace morphe::reconstruct
