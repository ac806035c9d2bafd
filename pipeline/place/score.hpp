#pragma once

#include "core/collision/world.hpp"
#include "pipeline/place/stand.hpp"
#include "pipeline/place/trials.hpp"
#include "stages/map/movement_search.hpp"

namespace morphe::place {

/// What a placement is worth in a movement (means over its frames), or in several (means of these).
struct Measures {
  double out_of_reach = 0;  ///< share of tip goals that are missed by more than 2 mm
  double tip_error_m = 0;   ///< mean, each at most 200 mm
  double colliding = 0;     ///< share of frames with less than the margin
  double depth_m = 0;       ///< mean of what the margin lacks
  double upper_arm = 0;     ///< between the upper arms' directions [rad]
  double palm = 0;          ///< between the robot's palm frame and the human hand's [rad]
  double near_limits = 0;   ///< 0 … 1: how far the arm's joints are inside the last 0.15 rad
  double speed = 0;         ///< largest velocity over its limit, at the human's tempo
};
Measures mean_of(const std::vector<Measures>& all);

/// In degrees of the upper arm: what each is worth of it. Lower is better.
///   5 a percent out of reach, 2 a millimetre of tip error: a plan must reach, whatever it looks
///   like 1 a percent of colliding frames, 1 a millimetre of depth: repair can undo a little 1 a
///   degree of the upper arm; 0.15 of the palm, which differs by 25-50 anyway, hand by hand 10 for
///   joints at their limits all the time, 10 for twice a speed limit: they cost tempo alone
double cost_of(const Measures& measures);

/// The measures of postures [frames of problem, joints].
Measures measure(const map::MappingProblem& problem, const JointRows& q);

/// How thoroughly a placement is tried.
struct Effort {
  std::size_t frames = 8;  ///< of a movement
  int key_frames = 2, starts = 6;
};

/// The config, mapped with that effort and placed elsewhere.
planning::PipelineConfig tried_config(const planning::PipelineConfig& config, const Stand& stand,
                                      const Effort& effort);

/// A placement tried on a movement: the postures of the few frames, and what they are worth.
struct Tried {
  JointRows q;
  Measures measures;
};
/// By a search from random starts.
Tried search(const planning::Planner& planner, const Stand& stand, const Trial& trial,
             const Effort& effort, std::uint64_t seed);
/// By smoothing alone from the postures of a placement nearby.
Tried follow(const planning::Planner& planner, const Stand& stand, const Trial& trial,
             const Effort& effort, const JointRows& near);

}  // namespace morphe::place
