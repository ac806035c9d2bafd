#include "stages/reconstruct/estimated_arm.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/math/statistics.hpp"
#include "stages/reconstruct/gaps.hpp"

namespace morphe::reconstruct {
namespace {

constexpr double kHandLengthShare = 0.108;  // Drillis and Contini 1966
constexpr double kShoulderBelowHeadShare = 0.115,
                 kShoulderAsideHeadShare = 0.109;  // shares of the stature

/// Returns the initial shoulder, below and beside the head or offset from the first wrist; unseen
/// without either.
Vec3 initial_shoulder(const human::ArmLengths& lengths, const HumanOptions& human,
                      const std::vector<Vec3>& head, const std::vector<Vec3>& wrist) {
  const Vec3 above = math::median_point(head);
  if (is_known(above)) {
    const double stature_m = lengths.upper_arm / human::arm_lengths_of_stature(1).upper_arm;
    return above + stature_m * Vec3(kShoulderAsideHeadShare, 0, -kShoulderBelowHeadShare);
  }
  const auto first = std::ranges::find_if(wrist, [](const Vec3& point) { return is_known(point); });
  return first == wrist.end() ? unknown_point() : Vec3(*first + human.shoulder_from_first_wrist);
}

void estimate_shoulder(const human::ArmLengths& lengths, const HumanOptions& human,
                       const std::vector<Vec3>& head, HumanMotion& motion) {
  const Vec3 wanted = initial_shoulder(lengths, human, head, motion.wrist);
  if (!is_known(wanted)) return;
  const double reach = human.max_reach_share * (lengths.upper_arm + lengths.forearm);
  const std::optional<Vec3> shoulder = human::shoulder_within_reach(wanted, motion.wrist, reach);
  if (!shoulder) {
    motion.reconstruction_notes.push_back(fmt::format(
        "no fixed shoulder position has all wrist positions within {:.0f} mm: no arm is estimated",
        kMillimetresPerMetre * reach));
    return;
  }
  std::ranges::fill(motion.shoulder, *shoulder);
  motion.estimated.push_back("shoulder");
  motion.reconstruction_notes.push_back(
      "the shoulder was not recorded: it is estimated (error usually below 65 mm); humanlikeness "
      "of the arm is relative to an estimate");
}

void estimate_elbow(const human::ArmLengths& lengths, const HumanOptions& human,
                    HumanMotion& motion) {
  for (std::size_t i = 0; i < motion.elbow.size(); ++i) {
    motion.elbow[i] =
        human::elbow_from_swivel(motion.shoulder[i], motion.wrist[i], lengths, human.elbow_swivel);
  }
  motion.estimated.push_back("elbow");
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
  if (never_seen(motion.elbow)) estimate_elbow(lengths, human, motion);
}

}  // namespace morphe::reconstruct
