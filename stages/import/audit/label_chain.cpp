#include "stages/import/audit/label_chain.hpp"

#include <algorithm>
#include <utility>

#include "core/math/statistics.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/guess/recorded_points.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// The parts of an arm in their order.
constexpr const char* kChainParts[] = {"shoulder girdle", "shoulder", "upper arm", "elbow",
                                       "forearm",         "wrist",    "hand"};

/// The columns of the points on one part of an arm.
using PartColumns = std::vector<std::size_t>;

/// The parts of both arms, and the tips of both hands.
struct ArmChains {
  std::vector<PartColumns> parts[2];
  PartColumns tips[2];
};

/// Returns true if a point is seen in at least half of the frames.
bool is_often_seen(const Array2D<Vec3>& frames, std::size_t column) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < frames.rows; ++i) count += is_known(frames(i, column)) ? 1 : 0;
  return 2 * count >= frames.rows;
}

ArmChains arm_chains(const Array2D<Vec3>& frames, const std::vector<std::string>& names) {
  ArmChains chains;
  for (const int side : {0, 1}) {
    const std::string prefix = side == 0 ? "right " : "left ";
    for (const char* part : kChainParts) {
      PartColumns columns;
      for (std::size_t k = 0; k < names.size(); ++k) {
        if (body_part(names[k]) == prefix + part && is_often_seen(frames, k)) columns.push_back(k);
      }
      if (!columns.empty()) chains.parts[side].push_back(std::move(columns));
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const std::string part = body_part(names[k]);
      if (part.starts_with(prefix) && part.ends_with(" tip") && is_often_seen(frames, k))
        chains.tips[side].push_back(k);
    }
  }
  return chains;
}

Vec3 centre_of(const Array2D<Vec3>& frames, std::size_t frame, const PartColumns& columns,
               const Permutation& source) {
  std::vector<Vec3> points;
  for (const std::size_t column : columns) points.push_back(frames(frame, source[column]));
  return mean_of(points);
}

/// Returns the length of both arms' ways in one frame [m]; NaN if a part is hidden.
double length_in(const Array2D<Vec3>& frames, std::size_t frame, const ArmChains& chains,
                 const Permutation& source) {
  double length_m = 0;
  for (const int side : {0, 1}) {
    std::vector<PartColumns> parts = chains.parts[side];
    if (!chains.tips[side].empty()) parts.push_back(chains.tips[side]);
    for (std::size_t p = 1; p < parts.size(); ++p) {
      length_m += (centre_of(frames, frame, parts[p], source) -
                   centre_of(frames, frame, parts[p - 1], source))
                      .norm();
    }
  }
  return length_m;
}

double median_length(const Array2D<Vec3>& frames, const ArmChains& chains,
                     const Permutation& source) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i < frames.rows; ++i) {
    const double length_m = length_in(frames, i, chains, source);
    if (std::isfinite(length_m)) lengths.push_back(length_m);
  }
  return math::median(std::move(lengths));
}

/// Returns the columns after the exchange of two parts that shortens the way most; `source` if none
/// shortens it enough.
Permutation after_best_exchange(const Array2D<Vec3>& frames, const ArmChains& chains,
                                const Permutation& source) {
  std::vector<const PartColumns*> parts;
  for (const auto& side : chains.parts) {
    for (const PartColumns& columns : side) parts.push_back(&columns);
  }
  Permutation best = source;
  double least_m = median_length(frames, chains, source) - kMinChainGain_m;
  for (std::size_t a = 0; a < parts.size(); ++a) {
    for (std::size_t b = a + 1; b < parts.size(); ++b) {
      if (parts[a]->size() != parts[b]->size()) continue;
      Permutation exchanged = source;
      for (std::size_t k = 0; k < parts[a]->size(); ++k)
        std::swap(exchanged[(*parts[a])[k]], exchanged[(*parts[b])[k]]);
      const double length_m = median_length(frames, chains, exchanged);
      if (!(length_m < least_m)) continue;
      least_m = length_m;
      best = std::move(exchanged);
    }
  }
  return best;
}

}  // namespace

Permutation shortest_chain(const Array2D<Vec3>& frames, const std::vector<std::string>& names) {
  const ArmChains chains = arm_chains(frames, names);
  Permutation source = identity_permutation(names.size());
  if (frames.rows < kMinChainFrames) return source;
  for (int exchange = 0; exchange < kMaxLabelChanges; ++exchange) {
    Permutation next = after_best_exchange(frames, chains, source);
    if (next == source) break;
    source = std::move(next);
  }
  return source;
}

}  // namespace morphe::imports
