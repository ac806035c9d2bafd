#pragma once

#include <string>

namespace morphe::verify {

/// One thing that does not hold, at its worst place; neighbouring samples with the same cause and
/// subject are one violation.
///
/// cause        subject                  value, limit
/// structure    dataset or object        status and content do not go together, shapes do not fit
/// finite       dataset or object        a number that is none
/// time         dataset                  time or demonstration_time runs back, or leaves goals out
/// rest         joint                    velocity or acceleration at an end; 1e-9
/// position     joint                    rad; limit, tolerance 1e-6 of the joint's range
/// velocity, acceleration, jerk  joint   magnitude; limit, relative tolerance 1e-6
/// tracking     tip                      m from its goal; tolerance of the plan at that phase, and
///                                       1e-4 m between samples
/// self         capsule/capsule          m of clearance; clearance required, tolerance 1e-6 m
/// object       capsule/object           the same
/// status       what was allowed         share of goals out of reach, or m of a tip from its goal,
///                                       of a plan called by the wrong name; what it allows
/// grasp        dataset of grasp/        m or rad from what trajectory and scene make it
/// contact      tip/what                 as stages/verify/grasp_contacts.hpp has it
/// quality      attribute                what is stored; what could be (grasp_quality.hpp)
/// squeeze      tip/what, or dataset     as stages/verify/squeeze.hpp has it
/// certificate  attribute                what is stored; what was recomputed
/// clearance    trajectory               m stored for a sample; what was recomputed, 1e-4
/// goals        dataset of goals/        as stages/verify/promised_goals.hpp has it
/// phase        phase, or trajectory     as stages/verify/phases.hpp has it
/// scene        object, or dataset       as stages/verify/scene.hpp has it
/// mapped       dataset of mapped/       what is stored; what was recomputed (mapped.hpp)
/// path         dataset of path/         as stages/verify/path.hpp has it
/// transfer     what of it               as stages/verify/transfer.hpp has it
/// config       attribute, or a sentence what is stored; what the file's config asks for
/// robot        column of /robot         what is stored; what the file's inputs make of it
struct Violation {
  std::string plan;
  int sample = -1;    ///< the trajectory's sample nearest to time_s, -1: the plan as a whole
  double time_s = 0;  ///< on the trajectory's clock
  std::string cause, subject;
  double value = 0, limit = 0;
  std::string unit;  ///< of both; "" of a count, a share or a ratio
};

}  // namespace morphe::verify
