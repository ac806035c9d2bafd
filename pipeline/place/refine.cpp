#include "pipeline/place/refine.hpp"

#include <utility>

#include "core/math/seed.hpp"
#include "pipeline/place/reach.hpp"

namespace morphe::place {
namespace {

const Effort kRefining{10, 2, 6};

/// A place with the postures that its cost was measured with.
struct Visited {
  Candidate at;
  std::vector<JointRows> q;  ///< [trials]
};

Visited visited(const Stand& stand, std::vector<Tried> tried) {
  Visited visit;
  std::vector<Measures> all;
  for (Tried& one : tried) {
    all.push_back(one.measures);
    visit.q.push_back(std::move(one.q));
  }
  const Measures mean = mean_of(all);
  visit.at = {stand, mean, cost_of(mean)};
  return visit;
}

Visited search_all(const planning::Planner& planner, const Stand& stand,
                   const std::vector<Trial>& trials, std::uint64_t seed) {
  std::vector<Tried> tried;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    tried.push_back(
        search(planner, stand, trials[k], kRefining, math::seed_from(seed, "trial", k)));
  }
  return visited(stand, std::move(tried));
}

Visited follow_all(const planning::Planner& planner, const Stand& stand,
                   const std::vector<Trial>& trials, const Visited& from) {
  std::vector<Tried> tried;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    tried.push_back(follow(planner, stand, trials[k], kRefining, from.q[k]));
  }
  return visited(stand, std::move(tried));
}

/// A step along one of six ways: shifts, then turns about the world's axes through the shoulder.
Stand stepped(const Stand& stand, int way, double shift_m, double turn_rad) {
  Stand next = stand;
  const Vec3 axis = Vec3::Unit(way % 3);
  if (way < 3) {
    next.shoulder_offset += shift_m * axis;
  } else {
    next.world_from_base =
        (Quat(Eigen::AngleAxisd(turn_rad, axis)) * stand.world_from_base).normalized();
  }
  return next;
}

bool same(const Stand& a, const Stand& b) {
  return (a.shoulder_offset - b.shoulder_offset).norm() < 1e-6 &&
         angle_between(a.world_from_base, b.world_from_base) < 1e-6;
}

}  // namespace

Candidate try_stand(const planning::Planner& planner, const Stand& stand,
                    const std::vector<const Trial*>& trials, const Effort& effort,
                    std::uint64_t seed) {
  std::vector<Measures> all;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    all.push_back(
        search(planner, stand, *trials[k], effort, math::seed_from(seed, "trial", k)).measures);
  }
  const Measures mean = mean_of(all);
  return {stand, mean, cost_of(mean)};
}

Candidate refine(const planning::Planner& planner, const Stand& start, const Steps& steps,
                 const Stand& configured, const std::vector<Trial>& trials,
                 const Vec3& robot_shoulder, const PlaceOptions& options, std::uint64_t seed) {
  constexpr int kMostRounds = 4;
  constexpr double kGain = 0.02;  // degrees: less is not worth a step
  double shift_m = steps.shift_m, turn_rad = steps.turn_rad;
  Visited best = search_all(planner, start, trials, seed);
  for (int level = 0; level < steps.levels; ++level, shift_m /= 2, turn_rad /= 2) {
    if (level > 0) {
      const std::uint64_t again = math::seed_from(seed, "again", static_cast<std::size_t>(level));
      Visited anew = search_all(planner, best.at.stand, trials, again);
      if (anew.at.cost < best.at.cost) best = std::move(anew);
    }
    bool gained = true;
    for (int round = 0; gained && round < kMostRounds; ++round) {
      gained = false;
      for (int way = 0; way < 6; ++way) {
        for (const double sign : {1.0, -1.0}) {
          const Stand next = allowed(stepped(best.at.stand, way, sign * shift_m, sign * turn_rad),
                                     configured, options);
          if (same(next, best.at.stand) ||
              !base_is_free(trials, next, robot_shoulder, planner.robot.side, options)) {
            continue;
          }
          Visited there = follow_all(planner, next, trials, best);
          if (there.at.cost > best.at.cost - kGain) continue;
          best = std::move(there);
          gained = true;
          break;
        }
      }
    }
  }
  return best.at;
}

}  // namespace morphe::place
