#include "pipeline/place/place_options.hpp"

#include <fmt/format.h>

#include <numbers>

namespace morphe::place {

std::string validation_error(const PlaceOptions& options) {
  if (!(options.max_tilt_rad >= 0 && options.max_tilt_rad <= std::numbers::pi / 2))
    return "tilt: must be from 0 to 90 degrees";
  if (!(options.person_clearance_m >= 0 && options.person_clearance_m < 1))
    return "person-clearance: must be from 0 to 1 m";
  const auto among = [](const char* key, int value, int most, const char* all) {
    if (value >= 1 && value <= most) return std::string();
    return fmt::format("{}: must be 1 to {}, {}, not {}", key, most, all, value);
  };
  for (const std::string& error :
       {among("candidates", options.candidates, options.samples, "the number of poses"),
        among("refine", options.refine, options.candidates, "the number of candidates"),
        among("plan", options.plan, options.refine, "the number of those that are refined")})
    if (!error.empty()) return error;
  if (options.movements < 1) return "movements: must be at least 1";
  if (options.jobs < 1) return "jobs: must be at least 1";
  return "";
}

}  // namespace morphe::place
