#include "stages/import/audit/held_rows.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <unordered_map>

#include "stages/import/audit/constants.hpp"

namespace morphe::imports {
namespace {

bool same_position(const PointStream& stream, std::size_t a, std::size_t b, std::size_t point) {
  return stream.position(a, point) == stream.position(b, point);
}

double step_length(const PointStream& stream, std::size_t row, std::size_t point) {
  return (stream.position(row, point) - stream.position(row - 1, point)).norm();
}

/// Returns true if the rows differ in the points that are seen in both, or in those that are seen.
bool rows_differ(const PointStream& stream, std::size_t a, std::size_t b) {
  for (std::size_t k = 0; k < stream.position.cols; ++k) {
    const bool known = is_known(stream.position(a, k));
    if (known != is_known(stream.position(b, k))) return true;
    if (known && !same_position(stream, a, b, k)) return true;
  }
  return false;
}

/// Returns a number that is the same for equal rows, and 0 for a row without a seen point.
std::uint64_t fingerprint(const PointStream& stream, std::size_t row) {
  constexpr std::uint64_t kPrime = 1099511628211U, kOffset = 14695981039346656037U;
  std::uint64_t hash = kOffset;
  bool seen = false;
  for (std::size_t k = 0; k < stream.position.cols; ++k) {
    const Vec3& point = stream.position(row, k);
    seen |= is_known(point);
    for (const double x : point)
      hash = (hash ^ (is_known(point) ? std::bit_cast<std::uint64_t>(x) : 1)) * kPrime;
  }
  return seen ? std::max<std::uint64_t>(hash, 1) : 0;
}

/// Returns the runs of rows in which a point is exactly where it was in the row before.
std::vector<HeldRows> equal_rows(const PointStream& stream, std::size_t point) {
  std::vector<HeldRows> runs;
  const std::size_t rows = stream.time.size();
  for (std::size_t begin = 1, end = 1; begin < rows; begin = end + 1) {
    for (end = begin; end < rows && same_position(stream, end, begin - 1, point);) ++end;
    if (end == begin) continue;
    HeldRows run{point, begin == 1 ? 0 : begin, end, 0, end == rows};
    if (!run.at_end) {
      run.size_m = step_length(stream, end, point);
    } else if (begin > 1 && end - begin >= kMinFrozenRows) {
      run.size_m = step_length(stream, begin - 1, point);
    }
    runs.push_back(run);
  }
  return runs;
}

/// Returns the largest distance of a point between a row and one of the rows after it.
double motion_between(const PointStream& stream, std::size_t from, std::size_t to) {
  double motion_m = 0;
  for (std::size_t i = from + 1; i <= to; ++i) {
    for (std::size_t k = 0; k < stream.position.cols; ++k) {
      const double distance = (stream.position(i, k) - stream.position(from, k)).norm();
      if (distance > motion_m) motion_m = distance;
    }
  }
  return motion_m;
}

/// Returns true if another point moves while one is held.
bool others_move(const PointStream& stream, const HeldRows& held) {
  return motion_between(stream, held.begin, held.end - 1) > kOthersMotion_m;
}

}  // namespace

std::vector<HeldRows> held_rows(const PointStream& stream, const StepTable& steps) {
  std::vector<HeldRows> found;
  if (steps.period_s <= 0) return found;
  for (std::size_t k = 0; k < stream.names.size(); ++k) {
    const double limit_m = std::max(kMinHeldJump_m, kOutlierPerNoise * steps.noise_m[k]);
    const std::vector<HeldRows> runs = equal_rows(stream, k);
    std::size_t equal = 0;
    for (const HeldRows& run : runs) equal += run.end - run.begin;
    for (const HeldRows& run : runs) {
      const std::size_t length = run.end - run.begin;
      const double others = kMaxEqualShare * static_cast<double>(stream.time.size() - length);
      const bool silent = length >= kMinSilentRows && static_cast<double>(equal - length) < others;
      if (run.size_m > limit_m || (silent && others_move(stream, run))) found.push_back(run);
    }
  }
  return found;
}

std::vector<RepeatedBlock> repeated_blocks(const PointStream& stream) {
  std::vector<RepeatedBlock> found;
  std::unordered_map<std::uint64_t, std::size_t> last_row;
  const std::size_t rows = stream.time.size();
  std::vector<std::size_t> original(rows, rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::uint64_t hash = fingerprint(stream, i);
    if (hash == 0) continue;
    const auto [earlier, is_new] = last_row.try_emplace(hash, i);
    if (!is_new && !rows_differ(stream, i, earlier->second)) original[i] = earlier->second;
    earlier->second = i;
  }
  for (std::size_t begin = 0, end = 0; begin < rows; begin = std::max(end, begin + 1)) {
    for (end = begin; end < rows && original[end] + (begin - original[begin]) == end;) ++end;
    if (original[begin] == rows || end - begin < kMinBlockRows) continue;
    if (motion_between(stream, original[begin], begin) > kMinHeldJump_m)
      found.push_back({begin, end, original[begin]});
  }
  return found;
}

}  // namespace morphe::imports
