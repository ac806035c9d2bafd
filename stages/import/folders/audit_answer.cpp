#include "stages/import/folders/audit_answer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/enum_names.hpp"
#include "stages/import/audit/audit.hpp"
#include "stages/import/guess/unresolved_import.hpp"

namespace morphe::imports {
namespace {

/// Returns the map from the recorded points to those in the world, a change of axes with scale.
Eigen::Matrix3d world_from_recorded_points(const RecordedPoints& world,
                                           const RecordedPoints& recorded) {
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero(), own = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < world.position.values.size(); ++i) {
    const Vec3 &in_world = world.position.values[i], &point = recorded.position.values[i];
    if (!is_known(in_world) || !is_known(point)) continue;
    cross += in_world * point.transpose();
    own += point * point.transpose();
  }
  return cross * own.inverse();
}

/// Returns the recorded axes that are these axes of the world.
std::string recorded_axes(const RecordingFormat& format, const RecordingFiles& files,
                          const std::string& world_axes) {
  const RecordedPoints world =
      recorded_points(read_distinct_rows(format, files).streams, files.hand);
  const RecordedPoints recorded =
      recorded_points(read_unchecked(format, files, "axes").streams, files.hand);
  if (world.position.values.size() != recorded.position.values.size()) return "";
  const Eigen::Matrix3d map =
      world_from_points(world_axes, "") * world_from_recorded_points(world, recorded);
  if (!map.allFinite()) return "";
  return fmt::format("{} {} {}", axis_word(map.row(0)), axis_word(map.row(1)),
                     axis_word(map.row(2)));
}

/// Returns the answer in the recording's own coordinates.
Guess answer_of(const RecordingFormat& format, const RecordingFiles& files,
                const AuditQuestion& question) {
  if (question.key == "unit")
    return guess_unit(recorded_points(read_unchecked(format, files, "unit").streams, files.hand));
  const std::string value =
      question.key == "axes" ? recorded_axes(format, files, question.value) : question.value;
  return {value, question.confidence, question.reason};
}

RecordingFiles with_answer(RecordingFiles files, const std::string& key, const std::string& value) {
  if (key == "axes") files.conventions.axes = value;
  if (key == "unit") files.conventions.unit = value;
  if (key == "hand") files.hand = enum_from_name<Side>(value).value_or(files.hand);
  return files;
}

/// Returns true if the recording can be read with these conventions and then lacks such a flag.
bool removes(const RecordingFormat& format, const RecordingFiles& files, FlagCode code) {
  try {
    Demonstration recording = read_distinct_rows(format, files);
    recording.hand = files.hand;
    const AuditInput answered{.file = files.file.string(),
                              .axes_given = true,
                              .unit_given = true,
                              .rate_given = true,
                              .hand_given = true};
    audit_recording(answered, recording);
    return std::ranges::none_of(recording.flags, [&](const RecordingFlag& flag) {
      return flag.code == code && flag.response == FlagResponse::flagged;
    });
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::optional<Guess> tested_answer(const RecordingFormat& format, const RecordingFiles& files,
                                   const Doubt& doubt) {
  const AuditQuestion& question = *doubt.question;
  const Guess answer = answer_of(format, files, question);
  if (question.key != "axes" && question.key != "unit" && question.key != "hand") return answer;
  if (answer.value.empty()) return std::nullopt;
  const RecordingFiles answered = with_answer(files, question.key, answer.value);
  return removes(format, answered, doubt.flag.code) ? std::optional(answer) : std::nullopt;
}

}  // namespace morphe::imports
