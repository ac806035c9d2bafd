#include "stages/import/audit/audit.hpp"

#include <algorithm>
#include <utility>

#include "stages/import/audit/checks.hpp"

namespace morphe::imports {

std::span<const AuditCheck> audit_checks() {
  static constexpr AuditCheck kChecks[] = {
      {"rows", check_rows},           {"jumps", check_jumps},
      {"labels", check_labels},       {"static_trial", check_static_trial},
      {"chirality", check_chirality}, {"vertical", check_vertical},
      {"scale", check_scale},         {"time_base", check_time_base},
      {"jitter", check_jitter},       {"objects", check_objects}};
  return kChecks;
}

std::optional<Doubt> audit_recording(const AuditInput& input, Demonstration& recording) {
  for (const AuditCheck& check : audit_checks()) {
    for (Doubt& doubt : check.find(recording, input)) {
      const bool accepted =
          std::ranges::find(input.accepted, doubt.flag.code) != input.accepted.end();
      doubt.flag.response = accepted     ? FlagResponse::accepted
                            : doubt.mend ? FlagResponse::mended
                                         : FlagResponse::flagged;
      if (!accepted && !doubt.mend && doubt.question) return std::move(doubt);
      if (!accepted && doubt.mend) doubt.mend(recording);
      recording.flags.push_back(std::move(doubt.flag));
    }
  }
  return std::nullopt;
}

}  // namespace morphe::imports
