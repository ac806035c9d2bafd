#pragma once

#include <string>

namespace morphe::planning {

/// The options for planning a movement of a hand without an arm in parts (config section `split`).
struct PartsOptions {
  double min_duration_s = 1;  ///< minimum duration of a part [s]
};
template <class Fields>
void fields(Fields& f, PartsOptions& o) {
  f("min_duration_s", o.min_duration_s);
}
/// Returns an error sentence, or "" if the options are valid.
std::string validation_error(const PartsOptions& options);

}  // namespace morphe::planning
