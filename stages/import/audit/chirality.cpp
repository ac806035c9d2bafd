#include "stages/import/audit/checks.hpp"

namespace morphe::imports {

std::vector<Doubt> check_chirality(const Demonstration& /*recording*/,
                                   const AuditInput& /*input*/) {
  return {};
}

}  // namespace morphe::imports
