#include "stages/reconstruct/reconstruct_options.hpp"

namespace morphe::reconstruct {

std::string validation_error(const ReconstructOptions& o) {
  return o.cutoff_hz < 0.4 * o.rate_hz ? "" : "cutoff_hz must be below 0.4 rate_hz";
}

}  // namespace morphe::reconstruct
