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

/// Calls a check that needs no step tables.
template <auto check>
std::vector<Doubt> without_steps(const Demonstration& recording, const AuditInput& input,
                                 StepTables& /*steps*/) {
  return check(recording, input);
}

bool is_mended(const RecordingFlag& flag) { return flag.response == FlagResponse::mended; }

}  // namespace

std::span<const AuditCheck> audit_checks() {
  // The static trial is compared once the size is known to be that of a person.
  static constexpr AuditCheck kChecks[] = {{"rows", check_rows},
                                           {"jumps", check_jumps},
                                           {"labels", without_steps<check_labels>},
                                           {"chirality", without_steps<check_chirality>},
                                           {"vertical", without_steps<check_vertical>},
                                           {"scale", without_steps<check_scale>},
                                           {"static_trial", without_steps<check_static_trial>},
                                           {"time_base", without_steps<check_time_base>},
                                           {"jitter", without_steps<check_jitter>},
                                           {"objects", without_steps<check_objects>}};
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
  StepTables steps;
  for (const AuditCheck& check : audit_checks()) {
    const std::size_t known = recording.flags.size();
    std::optional<Doubt> asked =
        answer_doubts(check.find(recording, input, steps), input, recording);
    if (asked) return asked;
    if (std::any_of(recording.flags.begin() + known, recording.flags.end(), is_mended))
      steps.clear();
  }
  return std::nullopt;
}

}  // namespace morphe::imports
