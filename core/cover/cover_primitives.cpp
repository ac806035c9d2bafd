#include "core/cover/cover_primitives.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/cover/constants.hpp"

namespace morphe::cover {
namespace {

using collision::CapsuleBody;

/// The best cover of one body with at most a given number of capsules.
struct PrimitiveCover {
  std::vector<CapsuleBody> capsules;
  double cost = kInfinity;  ///< square of the standoff, integrated over the body's surface [m⁴]
};

/// The covers of one body, by their largest number of capsules.
using PrimitiveCovers = std::vector<PrimitiveCover>;

void keep_better(PrimitiveCover cover, PrimitiveCovers& covers) {
  PrimitiveCover& best = covers[cover.capsules.size()];
  if (cover.cost < best.cost) best = std::move(cover);
}

/// Returns the values of e to be tried, from 0 to the largest.
std::array<double, kEndSteps + 1> end_offsets(double largest) {
  std::array<double, kEndSteps + 1> offsets{};
  for (int i = 0; i <= kEndSteps; ++i) offsets[i] = largest * i / kEndSteps;
  return offsets;
}

double squared(double x) { return x * x; }

/// Returns the parallel capsules of k × l cells. `half_chord` is the half length that a cell must
/// cover, by the distance of its nearest point from the middle plane.
template <class HalfChord>
std::vector<CapsuleBody> parallel_capsules(const Vec3& half, int k, int l, double e,
                                           const HalfChord& half_chord) {
  const double w = half.y() / k, d = half.z() / l, radius = std::sqrt(w * w + d * d + e * e);
  std::vector<CapsuleBody> capsules;
  for (int i = 0; i < k; ++i) {
    for (int j = 0; j < l; ++j) {
      const double y = (2 * i + 1 - k) * w, z = (2 * j + 1 - l) * d;
      const double end = std::max(0.0, half_chord(std::max(0.0, std::abs(y) - w)) - e);
      capsules.push_back({Vec3(-end, y, z), Vec3(end, y, z), radius});
    }
  }
  return capsules;
}

/// Tries all divisions into cells of a body whose half sizes are `half`, the longest first.
template <class HalfChord>
void try_cells(const Vec3& half, const HalfChord& half_chord, PrimitiveCovers& covers) {
  const int limit = static_cast<int>(covers.size()) - 1;
  for (int k = 1; k <= limit; ++k) {
    for (int l = 1; k * l <= limit; ++l) {
      const double w = half.y() / k, d = half.z() / l;
      for (const double e : end_offsets(std::min({w, d, half.x()}))) {
        const double radius = std::sqrt(w * w + d * d + e * e);
        const double cost = 8 * (half.x() * half.z() * squared(radius - w) +
                                 half.x() * half.y() * squared(radius - d) +
                                 kEndWeight * half.y() * half.z() * squared(radius - e));
        if (cost < covers[static_cast<std::size_t>(k) * l].cost)
          keep_better({parallel_capsules(half, k, l, e, half_chord), cost}, covers);
      }
    }
  }
}

PrimitiveCovers covers_of_box(const SceneObject& box, PrimitiveCovers covers) {
  std::array<int, 3> axis = {0, 1, 2};
  std::ranges::stable_sort(axis, [&](int a, int b) { return box.size[a] > box.size[b]; });
  Vec3 half;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) {
    half[k] = 0.5 * box.size[axis[k]];
    turn(axis[k], k) = 1;
  }
  try_cells(
      half, [&](double) { return half.x(); }, covers);
  for (PrimitiveCover& cover : covers) {
    for (CapsuleBody& capsule : cover.capsules) {
      capsule.from = turn * capsule.from;
      capsule.to = turn * capsule.to;
    }
  }
  return covers;
}

PrimitiveCovers covers_of_cylinder(const SceneObject& cylinder, PrimitiveCovers covers) {
  const double radius = cylinder.size[0], half_length = 0.5 * cylinder.size[1];
  for (const double e : end_offsets(std::min(radius, half_length))) {
    const double wide = std::hypot(radius, e);
    const double cost =
        4 * M_PI * radius *
        (half_length * squared(wide - radius) + 0.5 * kEndWeight * radius * squared(wide - e));
    const Vec3 end(0, 0, half_length - e);
    keep_better({{{-end, end, wide}}, cost}, covers);
  }
  const auto half_chord = [&](double from_middle) {
    return std::sqrt(std::max(0.0, radius * radius - from_middle * from_middle));
  };
  if (half_length < radius) try_cells({radius, radius, half_length}, half_chord, covers);
  return covers;
}

/// Returns the covers of a body with up to `limit` capsules in its own frame; empty for others than
/// spheres, boxes and cylinders.
PrimitiveCovers covers_of(const SceneObject& body, int limit) {
  PrimitiveCovers covers(static_cast<std::size_t>(limit) + 1);
  const bool has_size = !body.size.empty() && *std::ranges::min_element(body.size) > 0;
  if (!has_size) return {};
  if (body.shape == Shape::box) return covers_of_box(body, std::move(covers));
  if (body.shape == Shape::cylinder) return covers_of_cylinder(body, std::move(covers));
  if (body.shape != Shape::sphere) return {};
  keep_better({{{Vec3::Zero(), Vec3::Zero(), body.size[0]}}, 0}, covers);
  return covers;
}

/// Chooses the number of capsules of each body such that the sum of the costs is least.
std::vector<std::size_t> share_budget(const std::vector<PrimitiveCovers>& covers, int budget) {
  const std::size_t count = covers.size(), total = static_cast<std::size_t>(budget);
  // cost[i][n]: least cost of the first i bodies with n capsules; used[i][n]: those of the last.
  std::vector<std::vector<double>> cost(count + 1, std::vector<double>(total + 1, kInfinity));
  std::vector<std::vector<std::size_t>> used(count + 1, std::vector<std::size_t>(total + 1, 0));
  cost[0].assign(total + 1, 0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t n = 1; n <= total; ++n) {
      for (std::size_t own = 1; own < covers[i].size() && own <= n; ++own) {
        const double sum = cost[i][n - own] + covers[i][own].cost;
        if (sum >= cost[i + 1][n]) continue;
        cost[i + 1][n] = sum;
        used[i + 1][n] = own;
      }
    }
  }
  std::vector<std::size_t> shares(count);
  for (std::size_t i = count, n = total; i-- > 0;) {
    shares[i] = used[i + 1][n];
    n -= shares[i];
  }
  return shares;
}

}  // namespace

std::vector<CapsuleBody> cover_primitives(const std::vector<SceneObject>& bodies, int budget) {
  const int limit = std::min(budget - static_cast<int>(bodies.size()) + 1, kMaxPerPrimitive);
  if (bodies.empty() || limit < 1) return {};
  std::vector<PrimitiveCovers> covers;
  for (const SceneObject& body : bodies) {
    covers.push_back(covers_of(body, limit));
    if (covers.back().empty()) return {};
  }
  const std::vector<std::size_t> shares = share_budget(covers, budget);
  std::vector<CapsuleBody> capsules;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Pose pose = make_pose(bodies[i].position[0], bodies[i].orientation[0]);
    for (const CapsuleBody& own : covers[i][shares[i]].capsules)
      capsules.push_back({pose * own.from, pose * own.to, own.radius + kRoundedNumber_m});
  }
  return capsules;
}

double distance_from_primitives(const std::vector<SceneObject>& bodies, const Vec3& point) {
  double least = kInfinity;
  for (const SceneObject& body : bodies) {
    Vec3 gradient;
    const Pose pose = make_pose(body.position[0], body.orientation[0]);
    least = std::min(least, collision::signed_distance(body, pose.inverse() * point, gradient));
  }
  return std::max(0.0, least);
}

}  // namespace morphe::cover
