#include "stages/scene/carried_target.hpp"

#include <algorithm>
#include <optional>

#include "core/math/rotation.hpp"
#include "stages/scene/infer_objects.hpp"

namespace morphe::scene {
namespace {

/// Thumb and index tip in one frame, and the hand.
struct TipPair {
  Vec3 middle, line;  ///< midpoint between the tips; unit vector from thumb to index
  Quat hand;          ///< orientation of the hand, NaN if not seen
};

std::optional<TipPair> tips_at(const HumanMotion& motion, int frame) {
  if (motion.tip.rows != motion.time.size() || motion.tip.cols <= kIndex) return std::nullopt;
  const Vec3 &thumb = motion.tip(frame, kThumb), &index = motion.tip(frame, kIndex);
  if (!is_known(thumb) || !is_known(index) || thumb == index) return std::nullopt;
  const bool oriented = motion.wrist_orientation.size() == motion.time.size();
  return TipPair{0.5 * (thumb + index), (index - thumb).normalized(),
                 oriented ? motion.wrist_orientation[frame] : unknown_rotation()};
}

/// Returns R(t) R(a)ᵀ of the header, with `from` at a and `to` at t.
Quat rotation_between(const TipPair& from, const TipPair& to) {
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
  std::optional<TipPair> first;
  for (int frame = 0; frame < std::ssize(motion.time); ++frame) {
    const double time_s = motion.time[frame];
    if (!(time_s >= target.attach_s - kTimeTolerance_s) || time_s > end_s + kTimeTolerance_s)
      continue;
    const std::optional<TipPair> tips = tips_at(motion, frame);
    if (!tips) continue;
    if (!first) {
      first = tips;
      target.time.clear();
      target.position.clear();
      target.orientation.clear();
    }
    const Quat rotation = rotation_between(*first, *tips);
    target.time.push_back(time_s);
    target.position.push_back(tips->middle + rotation * (position - first->middle));
    target.orientation.push_back((rotation * orientation).normalized());
  }
}

}  // namespace morphe::scene
