#include "stages/import/audit/checks.hpp"

namespace morphe::imports {

std::vector<Doubt> check_static_trial(const Demonstration& /*recording*/,
                                      const AuditInput& /*input*/) {
  return {};
}

}  // namespace morphe::imports
