#include "stages/map/clearance_term.hpp"

#include <algorithm>

#include "core/robot/forward.hpp"
#include "core/robot/tree.hpp"

namespace morphe::map {
namespace {

/// By which joints the two bodies of a pair come nearer.
void find_slope(const collision::CollisionWorld& world, const collision::PairSeparation& pair,
                const std::vector<Pose>& base_from_frame, JointVector& slope) {
  const RobotTable& robot = *world.robot;
  const auto frame_of = [&](int capsule) {
    return robot.capsules[static_cast<std::size_t>(capsule)].frame;
  };
  const int first = frame_of(pair.capsule), second = pair.object ? -1 : frame_of(pair.other);
  const int both = robot::common_ancestor(robot, first, second);  // turns them alike
  const collision::Separation& s = pair.separation;
  slope.setZero();
  robot::add_point_slope(robot, base_from_frame, first, both, s.on_first, -s.normal, slope);
  robot::add_point_slope(robot, base_from_frame, second, both, s.on_second, s.normal, slope);
}

}  // namespace

std::string why_invalid(const ClearanceTerm& term) {
  if (term.weight < 0) return "weight must not be negative";
  if (term.band_m <= 0) return "band must be positive";
  return "";
}

void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world,
                   const JointVector& q, double time_s, ClearanceScratch& scratch,
                   solve::Quadratic& model) {
  if (term.weight == 0) return;
  robot::forward(*world.robot, q, scratch.collision.base_from_frame);
  add_clearance(term, world, time_s, scratch, model);
}

void add_clearance(const ClearanceTerm& term, const collision::CollisionWorld& world, double time_s,
                   ClearanceScratch& scratch, solve::Quadratic& model) {
  if (term.weight == 0) return;
  collision::place_bodies(world, time_s, scratch.collision);
  collision::near_pairs(world, time_s, term.band_m, scratch.collision, scratch.pairs);
  JointVector& slope = scratch.slope;
  slope.resize(model.gradient.size());
  for (const collision::PairSeparation& pair : scratch.pairs) {
    // What may touch may come as far as the surface.
    const double band = pair.required < 0 ? std::min(term.band_m, -pair.required) : term.band_m;
    const double missing = band - pair.slack();
    if (missing <= 0) continue;
    find_slope(world, pair, scratch.collision.base_from_frame, slope);
    model.value += term.weight * missing * missing;
    scratch.parts.clear();
    for (Eigen::Index j = 0; j < slope.size(); ++j) {
      if (slope[j] != 0) scratch.parts.push_back(j);
    }
    for (const Eigen::Index j : scratch.parts) {
      model.gradient[j] += 2 * term.weight * missing * slope[j];
      const double heavy = 2 * term.weight * slope[j];
      for (const Eigen::Index i : scratch.parts) model.hessian(i, j) += heavy * slope[i];
    }
  }
}

}  // namespace morphe::map
