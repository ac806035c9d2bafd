#include "stages/scene/other_arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/math/rotation.hpp"
#include "core/math/statistics.hpp"
#include "core/motion/human_motion.hpp"

namespace morphe::scene {
namespace {

using Points = std::vector<Vec3>;

constexpr double kHandForearmRatio = 0.108 / 0.146;    // shares of the stature, Drillis and Contini
constexpr double kDefaultHandLength_m = 0.108 * 1.70;  // for a stature of 1.70 m
constexpr double kMinBoneLength_m = 1e-6;              // length below which joints coincide
constexpr std::string_view kOtherArmLabel = "the person's other arm";

/// Returns the mean of the tips seen in a frame, without the thumb's; if no other is seen, the
/// thumb's.
Vec3 middle_of_tips(const HumanMotion& motion, std::size_t frame) {
  if (motion.tip.rows <= frame) return unknown_point();
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t finger = kIndex; finger < motion.tip.cols; ++finger) {
    if (!is_known(motion.tip(frame, finger))) continue;
    sum += motion.tip(frame, finger);
    ++count;
  }
  if (count > 0) return sum / count;
  return motion.tip.cols > kThumb ? motion.tip(frame, kThumb) : unknown_point();
}

/// Returns the far end of the hand in each frame, unseen if no direction of the hand is known.
Points hand_ends(const HumanMotion& motion, std::vector<std::string>& notes) {
  const std::size_t frames = motion.time.size();
  Points ends(frames);
  for (std::size_t i = 0; i < frames; ++i) ends[i] = middle_of_tips(motion, i);
  const double seen_m = math::median_distance(motion.wrist, ends);  // NaN if never seen together
  const double forearm_m = math::median_distance(motion.elbow, motion.wrist);
  const double length_m = std::isfinite(seen_m)      ? seen_m
                          : std::isfinite(forearm_m) ? kHandForearmRatio * forearm_m
                                                     : kDefaultHandLength_m;
  int oriented = 0, straight = 0;
  for (std::size_t i = 0; i < frames; ++i) {
    if (is_known(ends[i]) || !is_known(motion.wrist[i])) continue;
    const Vec3 along = motion.wrist[i] - motion.elbow[i];
    if (is_known(motion.wrist_orientation[i])) {
      ends[i] = motion.wrist[i] + motion.wrist_orientation[i] * Vec3(0, 0, length_m);
      ++oriented;
    } else if (along.norm() > kMinBoneLength_m) {
      ends[i] = motion.wrist[i] + length_m * along.normalized();
      ++straight;
    }
  }
  for (const auto& [count, how] : {std::pair{oriented, "along the hand's orientation"},
                                   std::pair{straight, "in line with its forearm"}}) {
    if (count == 0) continue;
    notes.push_back(
        fmt::format("{}: no fingertip seen in {} of {} frames: there the hand is placed {}",
                    kOtherArmLabel, count, frames, how));
  }
  return ends;
}

/// Adds a note on the frames of the recording in which a body has no pose of its own.
void note_gaps(const SceneObject& body, const std::vector<double>& time,
               std::vector<std::string>& notes) {
  if (body.time.size() == time.size()) return;
  double longest_s = std::max(body.time.front() - time.front(), time.back() - body.time.back());
  for (int k = 1; k < std::ssize(body.time); ++k)
    longest_s = std::max(longest_s, body.time[k] - body.time[k - 1]);
  notes.push_back(
      fmt::format("{}: not seen in {} of {} frames, for up to {:.2f} s: interpolated linearly "
                  "between, and held before the first and after the last",
                  body.name, time.size() - body.time.size(), time.size(), longest_s));
}

/// Returns the capsule between two joints, without poses if they were never seen together.
SceneObject capsule_between(const char* name, double radius_m, const std::vector<double>& time,
                            const Points& from, const Points& to, std::vector<std::string>& notes) {
  SceneObject body;
  body.name = name;
  body.shape = Shape::capsule;
  const double length_m = math::median_distance(from, to);
  if (std::isnan(length_m)) return body;
  body.size = {radius_m, length_m};
  double longest_m = 0;
  Quat turn = Quat::Identity();  // of z to the bone, by the shortest rotation from frame to frame
  for (int i = 0; i < std::ssize(time); ++i) {
    const Vec3 along = to[i] - from[i];
    if (!(along.norm() > kMinBoneLength_m)) continue;
    turn = (math::shortest_rotation(turn * Vec3::UnitZ(), along) * turn).normalized();
    body.time.push_back(time[i]);
    body.position.emplace_back((from[i] + to[i]) / 2);
    body.orientation.push_back(turn);
    longest_m = std::max(longest_m, along.norm());
  }
  if (body.time.empty()) return body;
  note_gaps(body, time, notes);
  if (longest_m > length_m + 2 * radius_m) {
    notes.push_back(
        fmt::format("{}: {:.0f} mm long, but its joints are {:.0f} mm apart in a frame: they are "
                    "then outside of it",
                    name, 1e3 * length_m, 1e3 * longest_m));
  }
  return body;
}

void note_estimates(const HumanMotion& motion, std::vector<std::string>& notes) {
  std::string joints;
  for (const char* joint : {"shoulder", "elbow"}) {
    if (std::ranges::find(motion.estimated, joint) == motion.estimated.end()) continue;
    joints += (joints.empty() ? "" : " and ") + std::string(joint);
  }
  if (joints.empty()) return;
  notes.push_back(fmt::format("{}: {} not recorded: estimated", kOtherArmLabel, joints));
}

}  // namespace

std::vector<SceneObject> other_arm_capsules(const SceneOptions& options, const HumanMotion& other,
                                            std::vector<std::string>& notes) {
  const auto unseen = [](const Points& points) {
    return std::ranges::none_of(points, [](const Vec3& point) { return is_known(point); });
  };
  if (unseen(other.shoulder) && unseen(other.elbow) && unseen(other.wrist)) {
    notes.push_back(fmt::format("{} was not recorded: it is not an obstacle", kOtherArmLabel));
    return {};
  }
  note_estimates(other, notes);
  const Points ends = hand_ends(other, notes);
  const std::array<std::array<const Points*, 2>, 3> bones = {
      {{&other.shoulder, &other.elbow}, {&other.elbow, &other.wrist}, {&other.wrist, &ends}}};
  std::vector<SceneObject> capsules;
  for (int k = 0; k < std::ssize(bones); ++k) {
    const auto& [from, to] = bones[k];
    SceneObject body = capsule_between(kOtherArmNames[k], options.other_arm_radii[k], other.time,
                                       *from, *to, notes);
    if (body.time.empty()) {
      notes.push_back(fmt::format("{} was not recorded: it is not an obstacle", kOtherArmNames[k]));
    } else {
      capsules.push_back(std::move(body));
    }
  }
  return capsules;
}

}  // namespace morphe::scene
