#pragma once

#include <vector>

#include "pipeline/collision/world.hpp"
#include "pipeline/humanlike/frame_objective.hpp"
#include "pipeline/motion/plan.hpp"
#include "stages/map/clearance_term.hpp"

namespace morphe {

/// One movement to be mapped: the objective of its frames in one place. Robot and world must
/// outlive it.
struct MappingProblem {
  const RobotTable* robot = nullptr;
  FrameObjective objective;
  ClearanceTerm clearance;
  const CollisionWorld* world = nullptr;  ///< what the mapping stays clear of
  std::vector<double> time;               ///< [F] demonstration time [s]
  std::vector<FrameGoal> goals;           ///< [F]

  std::size_t frames() const { return time.size(); }
};

struct MappingScratch {
  std::vector<Pose> base_from_frame;
  ClearanceScratch clearance;
  Quadratic model;
};

/// Adds the objective of a frame at q, clearance included, to `model`.
void add_frame(const MappingProblem& problem, std::size_t frame, const JointVector& q,
               MappingScratch& scratch, Quadratic& model);

/// smoothness * (jerk / limit)² per 10 ms as a weight on squared third differences of a path whose
/// frames are (time.back() - time.front()) / (F - 1) apart. [n]
JointVector third_difference_weight(const RobotTable& robot, const std::vector<double>& time,
                                    double smoothness);

inline constexpr double kReferenceStep = 0.01;  ///< weights count per frame of this length [s]
double mean_step(const std::vector<double>& time);

}  // namespace morphe
