#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "core/collision/world.hpp"
#include "core/humanlike/frame_objective.hpp"
#include "core/motion/plan.hpp"
#include "core/solve/quadratic.hpp"
#include "stages/map/clearance_term.hpp"

namespace morphe::map {

/// The branch that is preferred among good ones, and where to look for others
/// (reference_posture.hpp).
struct Reference {
  JointVector posture;  ///< [n], or empty: the cheapest branch is preferred
  /// [n] each: good postures of the robot for a person at rest, those that are preferred first.
  std::vector<JointVector> starts;
  humanlike::FrameGoal rest;  ///< the goals of the person at rest, unless the robot is a hand
  Vec3 common_base_offset = Vec3::Zero();  ///< as Goals::common_base_offset, of all movements [m]
};

/// The mapping of one movement: the objectives of all its frames. Robot and world must outlive it.
struct MappingProblem {
  const robot::Robot* robot = nullptr;
  humanlike::FrameObjective objective;               ///< objective of a single frame
  ClearanceTerm clearance;                           ///< added to the objective
  double wrist_motion = 0;                           ///< weight in PathProblem [s²/m²]
  const collision::CollisionWorld* world = nullptr;  ///< for the clearance; of the same robot
  std::vector<double> time;                          ///< [F] demonstration time [s]
  std::vector<humanlike::FrameGoal> goals;           ///< [F]
  Reference reference;                               ///< of the branch that is preferred
  /// Returns the number of frames.
  std::size_t frames() const { return time.size(); }
};

/// Buffers of add_frame_objective(), reused from call to call.
struct MappingScratch : humanlike::ObjectiveScratch {
  ClearanceScratch clearance;
  solve::Quadratic model;
};

/// Adds the objective of a frame at q, clearance included, to `model` (already sized n).
void add_frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                         MappingScratch& scratch, solve::Quadratic& model,
                         humanlike::Curvature curvature = humanlike::Curvature::gauss_newton);
/// Returns the objective of a frame at q, clearance included; `scratch.model` gets the gradient.
double frame_objective(const MappingProblem& problem, std::size_t frame, const JointVector& q,
                       MappingScratch& scratch);

/// Returns `count` positions inside the joint limits that are spread evenly along every joint: a
/// Latin hypercube, the same on any machine.
std::vector<JointVector> spread_starts(const RobotModel& robot, int count, std::uint64_t seed);

/// Returns a random position inside the joint limits, the same on any machine.
JointVector random_start(const RobotModel& robot, std::mt19937_64& random);

}  // namespace morphe::map
