#include "stages/reconstruct/gaps.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace morphe::reconstruct {

bool never_seen(const std::vector<Vec3>& points) {
  return std::ranges::none_of(points, [](const Vec3& p) { return is_known(p); });
}

void interpolate_unseen(std::vector<Vec3>& points) {
  int last = -1;  // the previous seen point; -1 if there is no such point
  for (int i = 0; i < std::ssize(points); ++i) {
    if (!is_known(points[i])) continue;
    const Vec3 before = last < 0 ? points[i] : points[last];
    for (int k = last + 1; k < i; ++k) {
      const double share = last < 0 ? 1 : static_cast<double>(k - last) / (i - last);
      points[k] = (1 - share) * before + share * points[i];
    }
    last = i;
  }
  if (last >= 0) std::fill(points.begin() + last + 1, points.end(), points[last]);
}

void note_gaps(const std::string& name, const std::vector<double>& time,
               const std::vector<Vec3>& recorded, const std::vector<Vec3>& filled, double max_gap_s,
               std::vector<std::string>& problems) {
  const std::ptrdiff_t n = std::ssize(time);
  std::ptrdiff_t hidden = 0, carried = 0, bridged = 0;
  double longest = 0;
  /// Calls use(begin, end) for every run of unseen points.
  const auto each_gap = [n](const std::vector<Vec3>& points, const auto& use) {
    for (std::ptrdiff_t begin = 0, end = 0; begin < n; begin = end + 1) {
      for (end = begin; end < n && !is_known(points[end]);) ++end;
      if (end > begin) use(begin, end);
    }
  };
  /// Returns the time from the last seen sample to the next one.
  const auto length = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    return time[std::min(end, n - 1)] - time[std::max<std::ptrdiff_t>(begin, 1) - 1];
  };
  each_gap(recorded, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    hidden += end - begin;
    longest = std::max(longest, length(begin, end));
    for (std::ptrdiff_t i = begin; i < end; ++i) carried += is_known(filled[i]) ? 1 : 0;
  });
  each_gap(filled, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    constexpr double kTimeTolerance_s = 1e-9;
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

}  // namespace morphe::reconstruct
