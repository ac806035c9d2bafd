#include "core/cover/choose_segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/cover/capsule_surface.hpp"
#include "core/cover/constants.hpp"
#include "core/cover/point_cloud.hpp"
#include "core/math/random_stream.hpp"

namespace morphe::cover {
namespace {

using collision::CapsuleBody;

double max_depth_m(const Voxels& voxels) {
  float depth = 0;
  for (std::ptrdiff_t cell = 0; cell < std::ssize(voxels.inside); ++cell)
    if (voxels.inside[cell]) depth = std::max(depth, voxels.distance[cell]);
  return depth;
}

/// The largest balls about every voxel that stand off the body by at most a growth.
struct Room {
  const Voxels& voxels;
  double growth_m;
  std::vector<float> radius;  ///< [voxels] [m]; empty: depth below the surface + growth

  Room(const Voxels& grid, const StandoffLimits& limits, double growth)
      : voxels(grid), growth_m(growth) {
    // The distance from the voxels that stand off too far is larger than depth + growth in hollows.
    if (growth_m <= 0 || growth_m > voxels.padding_m - voxels.step_m) return;
    std::vector<std::uint8_t> forbidden(voxels.inside.size(), 0);
    for (std::ptrdiff_t cell = 0; cell < std::ssize(forbidden); ++cell) {
      if (voxels.inside[cell]) continue;
      forbidden[cell] =
          voxels.distance[cell] > growth_m || (!limits.forbidden.empty() && limits.forbidden[cell]);
    }
    radius = distances_to(voxels, forbidden);
  }
  /// Returns the radius of the largest ball about a point, < 0 if there is none.
  double at(const Vec3& point) const {
    const std::ptrdiff_t cell = voxels.cell_of(point);
    if (cell < 0) return -1;
    if (!radius.empty()) return radius[cell] - 0.5 * voxels.step_m;
    return (voxels.inside[cell] ? voxels.distance[cell] : -voxels.distance[cell]) + growth_m;
  }
};

/// Sets the largest radius of a capsule, < 0 if there is none.
void set_radius(const Room& room, CapsuleBody& capsule) {
  const int steps = 1 + static_cast<int>((capsule.to - capsule.from).norm() / room.voxels.step_m);
  capsule.radius = kInfinity;
  for (int step = 0; step <= steps && capsule.radius >= 0; ++step) {
    const Vec3 point = capsule.from + (capsule.to - capsule.from) * step / steps;
    capsule.radius = std::min(capsule.radius, room.at(point));
  }
}

/// Returns the deepest of `draws` random interior points: with more, nearer to the medial axis.
Vec3 draw_inside(const Voxels& voxels, const std::vector<Vec3>& inside, int draws,
                 math::RandomStream& random) {
  Vec3 deepest = inside.front();
  float max_depth = -1;
  for (int k = 0; k < draws; ++k) {
    const Vec3& point =
        inside[static_cast<std::size_t>(random.uniform() * static_cast<double>(inside.size()))];
    const float depth = voxels.distance[voxels.cell_of(point)];
    if (depth > max_depth) deepest = point;
    max_depth = std::max(max_depth, depth);
  }
  return deepest;
}

/// Draws segments inside the body; a third of them have ends near the medial axis.
std::vector<CapsuleBody> draw_segments(const Voxels& voxels, math::RandomStream& random) {
  const std::vector<Vec3> inside = points_inside(voxels);
  const Room surface(voxels, {}, 0);
  std::vector<CapsuleBody> segments;
  for (int k = 0;
       std::ssize(segments) < kCandidateCount && k < kMaxDrawsPerCandidate * kCandidateCount; ++k) {
    const int draws = k % 3 == 0 ? kDeepDraws : 1;
    CapsuleBody body{draw_inside(voxels, inside, draws, random),
                     draw_inside(voxels, inside, draws, random), 0};
    if (k % kSpherePeriod == 0) body.to = body.from;
    set_radius(surface, body);
    if (body.radius >= 0) segments.push_back(body);
  }
  return segments;
}

/// A greedy choice of capsules of one growth.
struct GreedyCover {
  const Voxels& voxels;
  const Room room;
  const std::vector<Vec3>& directions;
  double max_depth_m;
  PointCloud uncovered;  ///< the points that no chosen capsule covers yet
  math::RandomStream random;
  std::vector<CapsuleBody> candidates;
  /// Upper bounds of the number of points that a candidate adds: they only fall, and save counting.
  std::vector<int> max_added;

  /// Returns the candidates that add most, the best first, at most kClimbedCandidates.
  std::vector<std::pair<int, int>> best_candidates() {
    std::vector<std::pair<int, int>> best;  // points added, candidate
    for (int s = 0; s < std::ssize(candidates); ++s) {
      const bool full = std::ssize(best) == kClimbedCandidates;
      if (max_added[s] == 0 || (full && max_added[s] <= best.back().first)) continue;
      max_added[s] = uncovered.count_inside(candidates[s]);
      if (full && max_added[s] <= best.back().first) continue;
      best.emplace_back(max_added[s], s);
      std::ranges::stable_sort(best, std::greater<>(), &std::pair<int, int>::first);
      if (std::ssize(best) > kClimbedCandidates) best.pop_back();
    }
    return best;
  }

  /// Moves the ends of a capsule at random while it adds more points; returns their number.
  int climb(CapsuleBody& capsule, int added) {
    double move_m = kClimbFirstMove_cells * voxels.step_m;
    for (int k = 0; k < kClimbMoves; ++k, move_m *= kClimbMoveFactor) {
      CapsuleBody moved = capsule;
      if (k % 3 != 1) moved.from += move_m * random.normal_vector3();
      if (k % 3 != 2) moved.to += move_m * random.normal_vector3();
      set_radius(room, moved);
      const int now = uncovered.count_inside(moved);
      if (now <= added) continue;
      capsule = moved;
      added = now;
    }
    return added;
  }

  /// Returns the ball that adds most of some random ones that hold an uncovered point.
  CapsuleBody ball_at_uncovered_point() {
    const auto p =
        static_cast<std::ptrdiff_t>(random.uniform() * static_cast<double>(uncovered.size()));
    const Vec3 point = uncovered.point(p);
    CapsuleBody best;
    int most = 0;
    for (int k = 0; k < kBallsPerPoint; ++k) {
      const Vec3 direction = random.normal_vector3().normalized();
      const double share = random.uniform();
      const double distance_m = share * share * (max_depth_m + room.growth_m);
      CapsuleBody ball{point + distance_m * direction, point + distance_m * direction, 0};
      set_radius(room, ball);
      if (ball.radius < distance_m) continue;
      const int added = uncovered.count_inside(ball);
      if (added <= most) continue;
      most = added;
      best = ball;
    }
    return best;
  }

  /// Returns the end of the longest way from a point on which a ball of this radius has room.
  Vec3 farthest(const Vec3& from, const Vec3& direction, double radius_m) const {
    Vec3 end = from;
    while (true) {
      const Vec3 next = end + voxels.step_m * direction;
      if (room.at(next) < radius_m) return end;
      end = next;
    }
  }

  /// Returns the ball, drawn out along the direction in which it adds most.
  CapsuleBody drawn_out(const CapsuleBody& ball) const {
    CapsuleBody best = ball;
    int most = uncovered.count_inside(ball);
    for (const Vec3& direction : directions) {
      const CapsuleBody drawn{farthest(ball.from, direction, ball.radius),
                              farthest(ball.from, -direction, ball.radius), ball.radius};
      const int added = uncovered.count_inside(drawn);
      if (added <= most) continue;
      most = added;
      best = drawn;
    }
    return best;
  }

  /// Returns at most `budget` capsules that cover all points, or none.
  std::vector<CapsuleBody> choose(int budget, bool with_climbing) {
    for (CapsuleBody& candidate : candidates) set_radius(room, candidate);
    std::vector<CapsuleBody> chosen;
    while (uncovered.size() > 0) {
      CapsuleBody best;
      int max_gain = 0;
      for (const auto& [gain, s] : best_candidates()) {
        CapsuleBody capsule = candidates[s];
        const int added = with_climbing ? climb(capsule, gain) : gain;
        if (added <= max_gain) continue;
        max_gain = added;
        best = capsule;
        if (!with_climbing) break;
      }
      for (int k = 0; with_climbing && k < (max_gain == 0 ? kMaxUncoveredSeeds : kUncoveredSeeds);
           ++k) {
        CapsuleBody capsule = drawn_out(ball_at_uncovered_point());
        const int added = climb(capsule, uncovered.count_inside(capsule));
        if (added <= max_gain) continue;
        max_gain = added;
        best = capsule;
      }
      // Later capsules hardly add more points than earlier ones.
      if (max_gain == 0 || uncovered.size() > max_gain * (budget - std::ssize(chosen))) return {};
      uncovered.remove_inside(best);
      chosen.push_back(best);
    }
    return chosen;
  }
};

}  // namespace

Segments choose_segments(const Voxels& voxels, const std::vector<Vec3>& points,
                         const std::vector<Vec3>& directions, int budget,
                         const StandoffLimits& limits, const std::string& name) {
  math::RandomStream random(2, name);
  const std::vector<CapsuleBody> candidates = draw_segments(voxels, random);
  const PointCloud cloud(points);
  const auto cover = [&](double growth_m, bool with_climbing) {
    GreedyCover greedy{
        voxels,     Room(voxels, limits, growth_m),
        directions, max_depth_m(voxels),
        cloud,      math::RandomStream(3, name),
        candidates, std::vector<int>(candidates.size(), std::numeric_limits<int>::max())};
    return Segments{greedy.choose(budget, with_climbing), growth_m};
  };
  Segments chosen = cover(limits.aim_m, true);
  if (!chosen.capsules.empty() || !limits.forbidden.empty()) return chosen;
  double high = voxels.step_m * voxels.count.cast<double>().norm();
  const auto bisect = [&](int count, bool with_climbing) {
    double low = limits.aim_m;
    for (int k = 0; k < count; ++k) {
      const double growth_m = 0.5 * (low + high);
      Segments choice = cover(growth_m, with_climbing);
      (choice.capsules.empty() ? low : high) = growth_m;
      if (!choice.capsules.empty()) chosen = std::move(choice);
    }
  };
  chosen = cover(high, false);
  bisect(kGrowthBisectionCount, false);
  bisect(kClimbBisectionCount, true);
  return chosen;
}

}  // namespace morphe::cover
