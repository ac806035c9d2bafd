#include "pipeline/motion/movement.hpp"

#include <algorithm>
#include <iterator>

namespace morphe {

int phase_at(const std::vector<Phase>& phases, double time_s) {
  const Phase* best = nullptr;
  for (const Phase& phase : phases) {
    if (time_s < phase.begin_s || time_s > phase.end_s) continue;
    const bool shorter = best && phase.end_s - phase.begin_s < best->end_s - best->begin_s;
    if (!best || shorter) best = &phase;
  }
  if (!best) return 0;
  const auto found = std::find(std::begin(kPhaseNames), std::end(kPhaseNames), best->name);
  return found == std::end(kPhaseNames) ? 0 : static_cast<int>(found - std::begin(kPhaseNames));
}

}  // namespace morphe
