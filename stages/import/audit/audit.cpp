#include "stages/import/audit/audit.hpp"

#include <algorithm>
#include <utility>

#include "stages/import/audit/checks.hpp"

namespace morphe::imports {
namespace {

bool is_accepted(const AuditInput& input, FlagCode code) {
  return std::ranges::find(input.accepted, code) != input.accepted.end();
}

/// Returns true if a doubt has a question for the user, to which there is an answer; sets it.
bool must_be_asked(const AuditInput& input, Doubt& doubt) {
  if (!doubt.question || !input.answer) return doubt.question.has_value();
  const std::optional<Guess> answer = input.answer(doubt);
  if (!answer) return false;
  doubt.question->value = answer->value;
  doubt.question->reason = answer->reason;
  doubt.question->confidence = answer->confidence;
  return true;
}

}  // namespace

std::span<const AuditCheck> audit_checks() {
  // The static trial is compared once the size is known to be that of a person.
  static constexpr AuditCheck kChecks[] = {{"rows", check_rows},
                                           {"jumps", check_jumps},
                                           {"labels", check_labels},
                                           {"chirality", check_chirality},
                                           {"vertical", check_vertical},
                                           {"scale", check_scale},
                                           {"static_trial", check_static_trial},
                                           {"time_base", check_time_base},
                                           {"jitter", check_jitter},
                                           {"objects", check_objects}};
  return kChecks;
}

std::optional<Doubt> answer_doubts(std::vector<Doubt> doubts, const AuditInput& input,
                                   Demonstration& recording) {
  for (Doubt& doubt : doubts) {
    const bool accepted = is_accepted(input, doubt.flag.code);
    if (!accepted && !doubt.mend && must_be_asked(input, doubt)) return std::move(doubt);
    if (!accepted && doubt.mend) doubt.mend(recording);
    doubt.flag.response = accepted     ? FlagResponse::accepted
                          : doubt.mend ? FlagResponse::mended
                                       : FlagResponse::flagged;
    recording.flags.push_back(std::move(doubt.flag));
  }
  return std::nullopt;
}

std::optional<Doubt> audit_recording(const AuditInput& input, Demonstration& recording) {
  for (RecordingFlag& flag : recording.flags) {
    if (is_accepted(input, flag.code)) flag.response = FlagResponse::accepted;
  }
  for (const AuditCheck& check : audit_checks()) {
    std::optional<Doubt> asked = answer_doubts(check.find(recording, input), input, recording);
    if (asked) return asked;
  }
  return std::nullopt;
}

}  // namespace morphe::imports
