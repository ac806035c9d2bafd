#include "stages/reconstruct/gaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace morphe::reconstruct {

bool never_seen(const std::vector<Vec3>& points) {
  return std::ranges::none_of(points, [](const Vec3& p) { return is_known(p); });
}

void interpolate_unseen(std::vector<Vec3>& points) {
  const std::size_t n = points.size();
  std::size_t last = n;  // the previous seen point; n if there is no such point
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_known(points[i])) continue;
    const std::size_t first = last == n ? 0 : last + 1;
    const Vec3 before = last == n ? points[i] : points[last];
    for (std::size_t k = first; k < i; ++k) {
      const double share =
          last == n ? 1 : static_cast<double>(k - last) / static_cast<double>(i - last);
      points[k] = (1 - share) * before + share * points[i];
    }
    last = i;
  }
  for (std::size_t k = last + 1; k < n; ++k) points[k] = points[last];
}

void note_gaps(const std::string& name, const std::vector<double>& time,
               const std::vector<Vec3>& recorded, const std::vector<Vec3>& filled, double max_gap_s,
               std::vector<std::string>& problems) {
  const std::size_t n = time.size();
  std::size_t hidden = 0, carried = 0, bridged = 0;
  double longest = 0;
  /// Calls use(begin, end) for every run of unseen points.
  const auto each_gap = [n](const std::vector<Vec3>& points, const auto& use) {
    for (std::size_t i = 0; i < n; ++i) {
      if (is_known(points[i])) continue;
      std::size_t end = i;
      while (end < n && !is_known(points[end])) ++end;
      use(i, end);
      i = end;
    }
  };
  /// Returns the time from the last seen sample to the next one.
  const auto length = [&](std::size_t begin, std::size_t end) {
    return time[std::min(end, n - 1)] - time[begin == 0 ? 0 : begin - 1];
  };
  each_gap(recorded, [&](std::size_t begin, std::size_t end) {
    hidden += end - begin;
    longest = std::max(longest, length(begin, end));
    for (std::size_t i = begin; i < end; ++i) carried += is_known(filled[i]) ? 1 : 0;
  });
  each_gap(filled, [&](std::size_t begin, std::size_t end) {
    constexpr double kTimeTolerance_s = 1e-9;  // [s]
    const bool inside = begin > 0 && end < n;
    if (inside && length(begin, end) <= max_gap_s + kTimeTolerance_s) bridged += end - begin;
  });
  if (hidden == 0) return;
  std::string sentence =
      fmt::format("{}: hidden in {} of {} frames, for up to {:.2f} s", name, hidden, n, longest);
  if (carried > 0) sentence += fmt::format("; filled in from its cluster in {}", carried);
  if (bridged > 0) sentence += fmt::format("; interpolated in {}", bridged);
  if (hidden > carried + bridged) {
    sentence += fmt::format("; missing in {}", hidden - carried - bridged);
  }
  problems.push_back(std::move(sentence));
}

void note_unseen(const std::string& name, const std::vector<Vec3>& points,
                 std::vector<std::string>& problems) {
  const auto count = std::ranges::count_if(points, [](const Vec3& p) { return !is_known(p); });
  if (count == 0) return;
  problems.push_back(fmt::format("{}: not seen in {} of {} frames", name, count, points.size()));
}

Residual residual_of(const std::string& name, const std::vector<double>& distances) {
  Residual residual{name, 0, 0};
  double sum = 0;
  std::size_t count = 0;
  for (const double distance : distances) {
    if (!std::isfinite(distance)) continue;
    sum += distance * distance;
    residual.max_m = std::max(residual.max_m, distance);
    ++count;
  }
  residual.rms_m = count == 0 ? kUnknown : std::sqrt(sum / static_cast<double>(count));
  if (count == 0) residual.max_m = kUnknown;
  return residual;
}

}  // namespace morphe::reconstruct
