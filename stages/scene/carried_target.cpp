#include "stages/scene/carried_target.hpp"

#include <algorithm>
#include <optional>

#include "core/math/rotation.hpp"
#include "stages/scene/infer_objects.hpp"

namespace morphe::scene {
namespace {

struct Grip {
  Vec3 middle, line;  ///< midpoint between the tips; unit vector from thumb to index
  Quat hand;          ///< orientation of the hand, NaN if not seen
};

std::optional<Grip> grip_at(const HumanMotion& motion, std::size_t frame) {
  if (motion.tip.rows != motion.time.size() || motion.tip.cols <= kIndex) return std::nullopt;
  const Vec3 &thumb = motion.tip(frame, kThumb), &index = motion.tip(frame, kIndex);
  if (!is_known(thumb) || !is_known(index) || thumb == index) return std::nullopt;
  const bool oriented = motion.wrist_orientation.size() == motion.time.size();
  return Grip{0.5 * (thumb + index), (index - thumb).normalized(),
              oriented ? motion.wrist_orientation[frame] : unknown_rotation()};
}

/// Returns R(t) R(a)ᵀ.
Quat rotation_between(const Grip& from, const Grip& to) {
  const Quat hand =
      is_known(from.hand) && is_known(to.hand) ? to.hand * from.hand.conjugate() : Quat::Identity();
  return (math::shortest_rotation(hand * from.line, to.line) * hand).normalized();
}

}  // namespace

void move_with_tips(const HumanMotion& motion, const Movement& movement, SceneObject& target) {
  if (target.time.size() != 1) return;
  const Vec3 position = target.position.front();
  const Quat orientation = target.orientation.front();
  const double end_s =
      std::isnan(target.release_s) ? movement.end_s : std::min(target.release_s, movement.end_s);
  std::optional<Grip> taken;
  for (std::size_t frame = 0; frame < motion.time.size(); ++frame) {
    const double time_s = motion.time[frame];
    if (!(time_s >= target.attach_s - kTimeTolerance_s) || time_s > end_s + kTimeTolerance_s)
      continue;
    const std::optional<Grip> grip = grip_at(motion, frame);
    if (!grip) continue;
    if (!taken) {
      taken = grip;
      target.time.clear();
      target.position.clear();
      target.orientation.clear();
    }
    const Quat turn = rotation_between(*taken, *grip);
    target.time.push_back(time_s);
    target.position.push_back(grip->middle + turn * (position - taken->middle));
    target.orientation.push_back((turn * orientation).normalized());
  }
}

}  // namespace morphe::scene
