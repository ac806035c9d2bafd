#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stages/import/audit/doubt.hpp"

namespace morphe::imports {

/// A check of a recording.
struct AuditCheck {
  const char* name;  ///< of its file: "labels"
  std::vector<Doubt> (*find)(const Demonstration& recording, const AuditInput& input);
};
/// Returns the checks in the order of the audit: each sees what those before it mended.
std::span<const AuditCheck> audit_checks();

/// Questions a recording with all checks. A doubt that `input` accepts is only flagged; otherwise
/// it is mended if that is certain, asked about if it has a question, and else flagged. Flags, also
/// of mended doubts, are added to `recording.flags`. Returns the first doubt with a question; the
/// recording should then not be used.
std::optional<Doubt> audit_recording(const AuditInput& input, Demonstration& recording);

}  // namespace morphe::imports
