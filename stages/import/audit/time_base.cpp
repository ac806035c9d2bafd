#include "stages/import/audit/checks.hpp"

namespace morphe::imports {

std::vector<Doubt> check_time_base(const Demonstration& /*recording*/,
                                   const AuditInput& /*input*/) {
  return {};
}

}  // namespace morphe::imports
