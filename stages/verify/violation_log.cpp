#include "stages/verify/violation_log.hpp"

#include <algorithm>
#include <tuple>

namespace morphe::verify {

void ViolationLog::note(const std::string& cause, const std::string& subject,
                        const CurvePoint& place, double value, double limit, double excess) {
  const Violation here{plan_, place.sample, place.time_s, cause, subject, value, limit, {}};
  const auto [entry, fresh] = open_.try_emplace({cause, subject}, Run{here, excess, place.step});
  if (fresh) return;
  Run& run = entry->second;
  if (place.step > run.last_step + 2) {
    closed_.push_back(run.worst);
    run = {here, excess, place.step};
    return;
  }
  run.last_step = place.step;
  if (excess > run.excess) {
    run.worst = here;
    run.excess = excess;
  }
}

void ViolationLog::note_plan(const std::string& cause, const std::string& subject, double value,
                             double limit) {
  closed_.push_back({plan_, -1, 0, cause, subject, value, limit, {}});
}

std::vector<Violation> ViolationLog::finish() {
  for (const auto& [key, run] : open_) closed_.push_back(run.worst);
  open_.clear();
  std::sort(closed_.begin(), closed_.end(), [](const Violation& a, const Violation& b) {
    return std::tie(a.sample, a.cause, a.subject, a.time_s) <
           std::tie(b.sample, b.cause, b.subject, b.time_s);
  });
  return std::exchange(closed_, {});
}

}  // namespace morphe::verify
