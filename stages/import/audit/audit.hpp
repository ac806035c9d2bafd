#pragma once

#include <optional>
#include <span>
#include <vector>

#include "stages/import/audit/doubt.hpp"
#include "stages/import/audit/step_table.hpp"

namespace morphe::imports {

/// A check of a recording.
struct AuditCheck {
  const char* name;  ///< of its file: "labels"
  std::vector<Doubt> (*find)(const Demonstration& recording, const AuditInput& input,
                             StepTables& steps);
};
/// Returns the checks in the order of the audit: each sees what those before it mended.
std::span<const AuditCheck> audit_checks();

/// Decides what follows from each doubt: it is only flagged if `input` accepts its code; otherwise
/// it is mended if that is certain, asked about if it has a question, and else flagged. Mends the
/// recording and adds the flags, also of mended doubts, to it. Returns the first doubt with a
/// question, after which the rest is not looked at.
std::optional<Doubt> answer_doubts(std::vector<Doubt> doubts, const AuditInput& input,
                                   Demonstration& recording);

/// Questions a recording, which may have flags of its reader, with all checks, and answers their
/// doubts. Returns the first doubt with a question; the recording should then not be used.
std::optional<Doubt> audit_recording(const AuditInput& input, Demonstration& recording);

}  // namespace morphe::imports
