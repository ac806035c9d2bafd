#pragma once

#include <string>

namespace morphe::verify {

/// A violated guarantee at its worst place; violations with the same cause and subject at
/// neighbouring samples are merged into one.
///
/// cause        subject                  value, limit
/// structure    dataset or object, or a sentence   the file differs from its format, status and
///                                       content are inconsistent, shapes do not match
/// finite       dataset or object        a number that is not finite
/// time         dataset                  time does not increase, demonstration_time decreases, or
///                                       they leave goals out
/// rest         joint                    velocity or acceleration at an end; 1e-9
/// position     joint                    rad; limit, tolerance 1e-6 of the joint's range
/// velocity, acceleration, jerk  joint   magnitude; limit, relative tolerance 1e-6
/// tracking     tip                      m from its goal; tolerance of the plan at that phase, and
///                                       1e-4 m between samples
/// self_collision    capsule/capsule     m of clearance; clearance required, tolerance 1e-6 m
/// object_collision  capsule/object, target/object   the same (carried_object.hpp)
/// release      target                   m from the nearest object at its release; 0.01
/// status       name of the allowance    share of goals out of reach or missing, m of a tip from
///                                       its goal, or s without a goal, of a plan with the wrong
///                                       status; the allowed value
/// grasp        dataset of grasp/        m or rad from the value given by trajectory and scene
/// contact      tip/property             see stages/verify/grasp_contacts.hpp
/// quality      attribute                stored value; attainable value (grasp_quality.hpp)
/// grasp_force  tip/property, or dataset see stages/verify/grasp_forces.hpp
/// certificate  attribute                stored value; recomputed value, NaN without a trajectory
/// clearance    trajectory               m stored for a sample; recomputed value, tolerance 1e-4
/// goals        dataset of goals/        see stages/verify/goals.hpp
/// phase        phase, or trajectory     see stages/verify/phases.hpp
/// scene        object, or dataset       see stages/verify/scene.hpp
/// mapped       dataset of mapped/       stored value; recomputed value (mapping.hpp)
/// branch       shoulder, elbow, wrist   as stored; as recomputed (branch.hpp)
/// path         dataset of path/         see stages/verify/path.hpp
/// approach_retreat  property            see stages/verify/approach_retreat.hpp
/// config       attribute, or a sentence stored value; value requested by the file's config
/// flag         code                     value and limit of a flag that the config refuses
/// robot        column of /robot         stored value; value derived from the file's inputs
/// recording    dataset or attribute     deviation from what the recording gives; 1e-6
struct Violation {
  std::string plan;   ///< its path; "" for the file as a whole
  int sample = -1;    ///< the trajectory's sample nearest to time_s; -1 for the plan as a whole
  double time_s = 0;  ///< on the trajectory's clock
  std::string cause, subject;
  double value = 0, limit = 0;
  std::string unit;  ///< of both; "" for a count, a share, a ratio or mixed units
};

}  // namespace morphe::verify
