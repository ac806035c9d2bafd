#include "stages/repair/connect.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/datastructures/NearestNeighborsSqrtApprox.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cassert>
#include <string_view>

#include "core/math/seed.hpp"
#include "stages/repair/constants.hpp"

namespace morphe::repair {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using RealVector = ob::RealVectorStateSpace::StateType;

/// Maps joint positions to coordinates: free joints in shares of their span, then the share of
/// their change that the following joints have made, times follow_length.
struct Coordinates {
  const ConnectSpace& space;
  const JointVector &from, &to;
  JointVector span;
  bool followers = false;
  double follow_length = 0;

  Coordinates(const RobotModel& robot, const ConnectSpace& searched, const JointVector& start,
              const JointVector& goal)
      : space(searched), from(start), to(goal), span((robot.upper - robot.lower).cwiseMax(1e-6)) {
    followers = space.joints.size() < robot.joints();
    for (int j = 0; j < span.size(); ++j) {
      const bool free = std::ranges::count(space.joints, j) > 0;
      if (!free) follow_length = std::max(follow_length, std::abs(to[j] - from[j]) / span[j]);
    }
    follow_length = std::max(follow_length, kMinFollowLength);
  }

  void read(const ob::State* state, JointVector& q) const {
    const double* values = state->as<RealVector>()->values;
    const double share = followers ? values[space.joints.size()] / follow_length : 0;
    q = from + share * (to - from);
    for (int i = 0; i < std::ssize(space.joints); ++i)
      q[space.joints[i]] = values[i] * span[space.joints[i]];
  }

  void write(const JointVector& q, double share, ob::State* state) const {
    double* values = state->as<RealVector>()->values;
    for (int i = 0; i < std::ssize(space.joints); ++i)
      values[i] = q[space.joints[i]] / span[space.joints[i]];
    if (followers) values[space.joints.size()] = share * follow_length;
  }
};

/// The working data of one call to plan_rrt_connect(); never shared between threads.
struct Query {
  const IntervalWorld& interval;
  const Coordinates& coordinates;
  collision::CollisionScratch scratch;
  JointVector first, second;

  bool is_free(const ob::State* state) {
    coordinates.read(state, first);
    return is_state_free(interval, first, scratch);
  }
  bool is_edge_free(const ob::State* a, const ob::State* b) {
    coordinates.read(a, first);
    coordinates.read(b, second);
    return is_motion_free(interval, first, second, scratch);
  }
};

class CertifiedEdges : public ob::MotionValidator {
 public:
  CertifiedEdges(const ob::SpaceInformationPtr& information, Query& query)
      : ob::MotionValidator(information), query_(query) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return query_.is_edge_free(a, b);
  }
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (query_.is_edge_free(a, b)) return true;
    last_valid.second = 0;
    if (last_valid.first) si_->copyState(last_valid.first, a);
    return false;
  }

 private:
  Query& query_;
};

/// Returns a seed for OMPL, which takes 32 bits and treats 0 as no seed.
std::uint32_t ompl_seed(std::uint64_t seed, std::string_view name) {
  return static_cast<std::uint32_t>(math::seed_from(seed, name) >> 32) | 1U;
}

// OMPL would seed its samplers in the order of their creation over all threads.
class SeededSampler : public ob::RealVectorStateSampler {
 public:
  SeededSampler(const ob::StateSpace* space, std::uint32_t seed)
      : ob::RealVectorStateSampler(space) {
    rng_.setLocalSeed(seed);
  }
};

class SeededConnect : public og::RRTConnect {
 public:
  SeededConnect(const ob::SpaceInformationPtr& information, std::uint32_t seed)
      : og::RRTConnect(information) {
    rng_.setLocalSeed(seed);
  }
};

}  // namespace

std::vector<JointVector> plan_rrt_connect(const IntervalWorld& interval, const ConnectSpace& space,
                                          const JointVector& from, const JointVector& to,
                                          int iterations, double range, std::uint64_t seed) {
  assert(!space.joints.empty());
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const Coordinates coordinates(*interval.world.environment.robot, space, from, to);
  Query query{interval, coordinates, {}, {}, {}};

  const auto dimension =
      static_cast<unsigned int>(space.joints.size() + (coordinates.followers ? 1 : 0));
  auto vectors = std::make_shared<ob::RealVectorStateSpace>(dimension);
  ob::RealVectorBounds bounds(dimension);
  bounds.setLow(0);
  bounds.setHigh(coordinates.follow_length);
  for (unsigned int i = 0; i < space.joints.size(); ++i) {
    const int j = space.joints[i];
    bounds.setLow(i, space.lower[j] / coordinates.span[j]);
    bounds.setHigh(i, space.upper[j] / coordinates.span[j] + 1e-12);
  }
  vectors->setBounds(bounds);
  vectors->setStateSamplerAllocator([seed](const ob::StateSpace* sampled) {
    return std::make_shared<SeededSampler>(sampled, ompl_seed(seed, "samples"));
  });

  auto information = std::make_shared<ob::SpaceInformation>(vectors);
  information->setStateValidityChecker([&query](const ob::State* s) { return query.is_free(s); });
  information->setMotionValidator(std::make_shared<CertifiedEdges>(information, query));
  information->setup();

  ob::ScopedState<> start(vectors), goal(vectors);
  coordinates.write(from, 0, start.get());
  coordinates.write(to, 1, goal.get());
  auto problem = std::make_shared<ob::ProblemDefinition>(information);
  problem->setStartAndGoalStates(start, goal);

  SeededConnect planner(information, ompl_seed(seed, "connect"));
  planner.setRange(range);
  // The default nearest-neighbour structure draws random numbers, too.
  if (iterations <= kMaxLinearSearchIterations)
    planner.setNearestNeighbors<ompl::NearestNeighborsLinear>();
  else
    planner.setNearestNeighbors<ompl::NearestNeighborsSqrtApprox>();
  planner.setProblemDefinition(problem);
  planner.setup();
  ob::IterationTerminationCondition limit(static_cast<unsigned int>(iterations));
  if (planner.solve(limit) != ob::PlannerStatus::EXACT_SOLUTION) return {};

  std::vector<JointVector> vertices;
  for (const ob::State* state : problem->getSolutionPath()->as<og::PathGeometric>()->getStates())
    coordinates.read(state, vertices.emplace_back());
  vertices.front() = from;
  vertices.back() = to;
  return vertices;
}

}  // namespace morphe::repair
