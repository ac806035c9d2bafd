#include "stages/import/audit/movement_checks.hpp"

namespace morphe::imports {

std::vector<RecordingFlag> check_grasp(const AuditedMovement& /*audited*/,
                                       const AuditOptions& /*options*/) {
  return {};
}

}  // namespace morphe::imports
