#include "stages/segment/contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/motion/extent.hpp"

namespace morphe::segment {
namespace {

constexpr double kBeside = 0.1;         ///< hand and object, however far off their frames are [m]
constexpr double kHandLength = 0.18;    ///< from the wrist to the fingertips [m]
constexpr double kLook_s = 0.1;         ///< before and after
constexpr double kSlip = 0.5;           ///< share of the way
constexpr double kLeastWay = 0.002;     ///< in twice kLook_s [m]
constexpr double kWidestHeld = 0.15;    ///< [m]
constexpr double kTipsFromSkin = 0.05;  ///< of both tips together, from the surface [m]
constexpr double kLeastWith_s = 0.1, kOnset_s = 0.2;

/// Whether a box lies between two fingertips that hold it, all in the box's frame.
bool between(const Eigen::AlignedBox3d& box, const Vec3& thumb, const Vec3& finger) {
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
  if (leaves < enters || leaves - enters > kWidestHeld) return false;
  const double inside = std::min(leaves, apart) - std::max(enters, 0.0);
  return inside > 0 && apart - inside < kTipsFromSkin;
}

bool goes_with(const Pose& before, const Pose& after, const Vec3& from, const Vec3& to) {
  const Vec3 would_go = after * (before.inverse() * from) - from;
  const double way = would_go.norm();
  return way > kLeastWay && (to - from - would_go).norm() < kSlip * way;
}

Contact contact_with(const SceneObject& object, const HumanMotion& motion,
                     const HandSignals& signals) {
  const std::size_t n = signals.frames();
  const bool has_tips = motion.tip.rows == n && motion.tip.cols == kFingers;
  const Eigen::AlignedBox3d box = extent_of(object, Pose::Identity());
  Contact contact{object.name, std::vector<double>(n, kNotSeen), std::vector<bool>(n),
                  std::vector<bool>(n)};
  std::vector<Pose> world_from_object(n);
  for (std::size_t i = 0; i < n; ++i) {
    world_from_object[i] = recorded_pose(object, motion.time[i]);
    const Pose object_from_world = world_from_object[i].inverse();
    std::array<Vec3, kFingers> tip;
    for (std::size_t finger = 0; has_tips && finger < kFingers; ++finger) {
      tip[finger] = object_from_world * motion.tip(i, finger);
      if (!seen(tip[finger])) continue;
      contact.distance[i] = std::fmin(contact.distance[i], box.exteriorDistance(tip[finger]));
      if (finger == kThumb || !seen(tip[kThumb])) continue;
      contact.held[i] = contact.held[i] || between(box, tip[kThumb], tip[finger]);
    }
    const Vec3 wrist = object_from_world * motion.wrist[i];
    if (!std::isnan(contact.distance[i]) || !seen(wrist)) continue;
    contact.distance[i] = std::max(0.0, box.exteriorDistance(wrist) - kHandLength);
  }
  if (object.time.size() < 2) return contact;
  const auto look = static_cast<std::size_t>(std::max(1.0, std::round(kLook_s / signals.step_s)));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = i > look ? i - look : 0, b = std::min(i + look, n - 1);
    contact.goes_with[i] =
        goes_with(world_from_object[a], world_from_object[b], signals.wrist[a], signals.wrist[b]) ||
        goes_with(world_from_object[a], world_from_object[b], signals.position[a],
                  signals.position[b]);
  }
  return contact;
}

/// A motion as far as the hand made it, and how far the fingertips were from the object.
struct HandMade {
  ObjectMotion motion;
  double distance = 0;  ///< mean [m]
};

/// Nothing of `way` is left if the hand did not make it.
HandMade made_by_hand(ObjectMotion motion, const Contact& contact, const HandSignals& signals) {
  const std::size_t begin = signals.frame(motion.begin_s), end = signals.frame(motion.end_s);
  std::size_t first = end, last = begin, count = 0;
  double distance = 0;
  for (std::size_t i = begin; i <= end; ++i) {
    if (!contact.goes_with[i] || !(contact.distance[i] < kBeside)) continue;
    if (count == 0) first = i;
    last = i;
    ++count;
    distance += contact.distance[i];
  }
  const double with_s = static_cast<double>(count) * signals.step_s;
  if (count == 0 || with_s < std::min(kLeastWith_s, (motion.end_s - motion.begin_s) / 2)) {
    motion.way = 0;
    return {motion, 0};
  }
  const double first_s = signals.time(static_cast<double>(first));
  const double last_s = signals.time(static_cast<double>(last));
  if (first_s > motion.begin_s + kOnset_s) motion.begin_s = first_s;
  if (last_s < motion.end_s - kOnset_s) motion.end_s = last_s;
  return {motion, distance / static_cast<double>(count)};
}

bool together(const ObjectMotion& a, const ObjectMotion& b) {
  const double common = std::min(a.end_s, b.end_s) - std::max(a.begin_s, b.begin_s);
  return common > 0.5 * std::min(a.end_s - a.begin_s, b.end_s - b.begin_s);
}

}  // namespace

std::vector<Contact> find_contacts(const HumanMotion& motion, const HandSignals& signals,
                                   const std::vector<SceneObject>& objects) {
  std::vector<Contact> contacts;
  if (signals.frames() == 0) return contacts;
  for (const SceneObject& object : objects) {
    if (!object.time.empty()) contacts.push_back(contact_with(object, motion, signals));
  }
  return contacts;
}

std::vector<ObjectMotion> moved_by_hand(const std::vector<ObjectMotion>& motions,
                                        const std::vector<Contact>& contacts,
                                        const HandSignals& signals) {
  std::vector<HandMade> made;
  for (const ObjectMotion& motion : motions) {
    const auto contact = std::ranges::find(contacts, motion.object, &Contact::object);
    if (contact == contacts.end()) continue;
    HandMade one = made_by_hand(motion, *contact, signals);
    if (one.motion.way > 0) made.push_back(std::move(one));
  }
  std::vector<ObjectMotion> result;
  for (const HandMade& one : made) {
    const bool farther = std::ranges::any_of(made, [&](const HandMade& other) {
      return other.motion.object != one.motion.object && together(other.motion, one.motion) &&
             other.distance < one.distance;
    });
    if (!farther) result.push_back(one.motion);
  }
  std::ranges::stable_sort(result, {}, &ObjectMotion::begin_s);
  return result;
}

std::string held_between(const std::vector<Contact>& contacts, const HandSignals& signals,
                         double from_s, double to_s, double least_s) {
  std::string object;
  double longest_s = least_s;
  for (const Contact& contact : contacts) {
    std::size_t count = 0;
    for (std::size_t i = signals.frame(from_s); i <= signals.frame(to_s); ++i) {
      count += contact.held[i] ? 1 : 0;
    }
    const double held_s = static_cast<double>(count) * signals.step_s;
    if (count == 0 || held_s < longest_s || (held_s == longest_s && !object.empty())) continue;
    longest_s = held_s;
    object = contact.object;
  }
  return object;
}

}  // namespace morphe::segment
