#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/motion/revisit.hpp"
#include "core/motion/task.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {
namespace {

/// Returns the frame of a motion that is nearest to a time.
std::size_t frame_of_visit(const HumanMotion& motion, double time_s) {
  const auto after = std::ranges::lower_bound(motion.time, time_s - kFrameTolerance_s);
  const auto last = std::prev(motion.time.end());
  return static_cast<std::size_t>(std::min(after, last) - motion.time.begin());
}

/// Returns the farthest distance of the wrist from a place between two times.
double farthest_from_place(const HumanMotion& motion, const Vec3& place, double from_s,
                           double to_s) {
  double farthest = 0;
  for (std::size_t i = frame_of_visit(motion, from_s); i <= frame_of_visit(motion, to_s); ++i) {
    if (is_known(motion.wrist[i])) farthest = std::max(farthest, (motion.wrist[i] - place).norm());
  }
  return farthest;
}

/// Returns the score with which a movement without a grasp visits the place of its first stop
/// again before it returns, as a hand does that puts down what it took; 0 if the place is above the
/// shoulder (strokes through the hair) or the hand does not return.
double second_visit(const HumanMotion& motion, const Movement& movement) {
  std::vector<Phase> reaches;
  for (const Phase& phase : movement.phases) {
    if (phase.kind == PhaseKind::reach) reaches.push_back(phase);
  }
  if (reaches.size() < 2 || !last_phase(movement, PhaseKind::return_phase)) return 0;
  const std::size_t stop = frame_of_visit(motion, reaches.front().end_s);
  const Vec3& place = motion.wrist[stop];
  const Vec3& start = motion.wrist[frame_of_visit(motion, reaches.front().begin_s)];
  const Vec3& last = motion.wrist[frame_of_visit(motion, reaches.back().end_s)];
  if (place.z() > motion.shoulder[stop].z()) return 0;
  const double score = revisit_score(
      place, last, (start - place).norm(),
      farthest_from_place(motion, place, reaches.front().end_s, reaches.back().end_s));
  return score > 0 ? score : 0;  // also if one of the points was not seen
}

}  // namespace

std::vector<RecordingFlag> check_grasp(const AuditedMovement& audited,
                                       const AuditOptions& /*options*/) {
  const Demonstration& recording = audited.recording;
  const HumanMotion& motion = audited.motion;
  const Movement& movement = audited.movement;
  if (movement.phases.empty() || motion.time.empty()) return {};
  if (last_phase(movement, PhaseKind::grasp)) return {};
  const bool takes_object = kind_of_task(recording.task) == TaskKind::takes_object;
  const double visit = second_visit(motion, movement);
  if (!takes_object && visit < kSecondVisit) return {};
  RecordingFlag flag{FlagCode::no_grasp, FlagResponse::flagged, movement.begin_s, movement.end_s};
  flag.value = visit;
  flag.limit = kSecondVisit;
  flag.unit = "1";
  flag.text = fmt::format(
      "{}, but no grasp was found from {:.2f} to {:.2f} s: only the reach is planned",
      takes_object ? fmt::format("the task '{}' takes an object", recording.task)
                   : "the hand comes back to the place of its reach, as if it had taken an object",
      movement.begin_s, movement.end_s);
  return {flag};
}

}  // namespace morphe::imports
