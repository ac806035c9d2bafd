#pragma once

#include <string>

namespace morphe::planning {

/// What of a long recording of a hand alone is executable (config section `parts`).
struct PartsOptions {
  double least_s = 1;  ///< parts are not made shorter than this
};
template <class Fields>
void fields(Fields& f, PartsOptions& o) {
  f("least_s", o.least_s);
}
std::string why_invalid(const PartsOptions& options);

}  // namespace morphe::planning
