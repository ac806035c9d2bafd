#pragma once

namespace morphe::imports {

// The limits of the audit's checks, a section for each file. docs/audit.md has the reason of each.

}  // namespace morphe::imports
