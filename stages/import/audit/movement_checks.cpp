#include "stages/import/audit/movement_checks.hpp"

#include <algorithm>
#include <iterator>

namespace morphe::imports {

void accept_flags(const Demonstration& recording, std::vector<RecordingFlag>& flags) {
  const std::vector<AcceptedFlag>& accepted = recording.accepted_flags;
  for (RecordingFlag& flag : flags) {
    if (std::ranges::find(accepted, flag.code, &AcceptedFlag::code) != accepted.end())
      flag.response = FlagResponse::accepted;
  }
}

std::vector<RecordingFlag> check_movement(const AuditedMovement& audited,
                                          const AuditOptions& options) {
  std::vector<RecordingFlag> flags;
  for (const auto check : {check_target, check_goals, check_completeness, check_grasp})
    std::ranges::move(check(audited, options), std::back_inserter(flags));
  accept_flags(audited.recording, flags);
  return flags;
}

std::vector<RecordingFlag> audit_movement(const AuditedMovement& audited,
                                          const AuditOptions& options) {
  std::vector<RecordingFlag> flags;
  std::ranges::copy_if(audited.recording.flags, std::back_inserter(flags),
                       [&](const RecordingFlag& flag) {
                         return flag.overlaps(audited.movement.begin_s, audited.movement.end_s);
                       });
  std::ranges::move(check_movement(audited, options), std::back_inserter(flags));
  return flags;
}

const RecordingFlag* refused_flag(const std::vector<RecordingFlag>& flags,
                                  const AuditOptions& options) {
  const auto refused = std::ranges::find_if(flags, [&](const RecordingFlag& flag) {
    return flag.response == FlagResponse::flagged &&
           std::ranges::find(options.refuse, flag.code) != options.refuse.end();
  });
  return refused == flags.end() ? nullptr : &*refused;
}

}  // namespace morphe::imports
