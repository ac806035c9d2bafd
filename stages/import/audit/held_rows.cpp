#include "stages/import/audit/held_rows.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "core/math/statistics.hpp"
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

/// Rows of which every second one is held; the row `end` is the first that goes on.
struct HeldStretch {
  std::size_t begin = 0, end = 0, held = 0;
};

std::vector<HeldStretch> stretches_of(const std::vector<HeldRows>& held) {
  std::map<std::size_t, std::size_t> end_of;
  for (const HeldRows& run : held) {
    if (run.begin > 0 && !run.at_end) end_of[run.begin] = run.end;
  }
  std::vector<HeldStretch> stretches;
  for (const auto& [begin, end] : end_of) {
    if (stretches.empty() || begin > stretches.back().end + 1) stretches.push_back({begin, end, 0});
    stretches.back().end = end;
    stretches.back().held += end - begin;
  }
  return stretches;
}

bool moves(const PointStream& stream, std::size_t row) {
  for (std::size_t k = 0; k < stream.names.size(); ++k) {
    if (step_length(stream, row, k) > 0) return true;
  }
  return false;
}

/// Returns the mean of the nearest steps before and behind a stretch that neither lead into a held
/// row nor out of one, [point]; empty if there are none.
std::vector<Vec3> usual_step_around(const PointStream& stream, const HeldStretch& stretch) {
  std::vector<std::size_t> rows;
  const auto is_free = [&](std::size_t row) {
    return moves(stream, row) && moves(stream, row - 1);
  };
  const auto window = static_cast<std::size_t>(kLocalWindow);
  const std::size_t last = std::min(stretch.end + window, stream.time.size() - 1);
  for (std::size_t n = 1; n <= window && rows.empty() && stretch.begin >= n + 2; ++n) {
    if (is_free(stretch.begin - n)) rows.push_back(stretch.begin - n);
  }
  for (std::size_t row = stretch.end + 1; row <= last; ++row) {
    if (!is_free(row)) continue;
    rows.push_back(row);
    break;
  }
  std::vector<Vec3> steps;
  for (std::size_t k = 0; k < stream.names.size() && !rows.empty(); ++k) {
    Vec3 sum = Vec3::Zero();
    for (const std::size_t row : rows) sum += stream.position(row, k) - stream.position(row - 1, k);
    steps.emplace_back(sum / static_cast<double>(rows.size()));
  }
  return steps;
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

double catch_up(const PointStream& stream, const std::vector<HeldRows>& held) {
  std::vector<double> shares;
  for (const HeldStretch& stretch : stretches_of(held)) {
    const std::vector<Vec3> usual = usual_step_around(stream, stretch);
    double product = 0, usual_square = 0;
    for (std::size_t k = 0; k < usual.size(); ++k) {
      const Vec3 way = stream.position(stretch.end, k) - stream.position(stretch.begin - 1, k);
      if (!is_known(usual[k]) || !is_known(way)) continue;
      product += way.dot(usual[k]);
      usual_square += usual[k].squaredNorm();
    }
    const double others = static_cast<double>(stretch.end - stretch.begin + 1 - stretch.held);
    if (usual_square > 0)
      shares.push_back((product / usual_square - others) / static_cast<double>(stretch.held));
  }
  return math::median(std::move(shares));
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
