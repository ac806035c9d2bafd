#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/motion/asked.hpp"
#include "pipeline/motion/export.hpp"
#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

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
/// contact      tip/what                 as pipeline/verify/grasp_contacts.hpp has it
/// quality      attribute                what is stored; what could be (grasp_quality.hpp)
/// squeeze      tip/what, or dataset     as pipeline/verify/squeeze.hpp has it
/// certificate  attribute                what is stored; what was recomputed
/// clearance    trajectory               m stored for a sample; what was recomputed, 1e-4
/// goals        dataset of goals/        as pipeline/verify/promised_goals.hpp has it
/// phase        phase, or trajectory     as pipeline/verify/phases.hpp has it
/// scene        object, or dataset       as pipeline/verify/scene.hpp has it
/// mapped       dataset of mapped/       what is stored; what was recomputed (mapped.hpp)
/// path         dataset of path/         as pipeline/verify/path.hpp has it
/// transfer     what of it               as pipeline/verify/transfer.hpp has it
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

struct VerifyReport {
  int executable = 0, approximate = 0, infeasible = 0;  ///< plans, as the file has them
  std::vector<Violation> violations;
};

/// Judges one plan by what docs/formats.md promises of it, with code of its own. Limits hold along
/// the quintic between samples (exact extrema); clearance and the way of tips from their goals are
/// proved there by bisection, and what stays open when nothing moves more than 0.01 mm counts as a
/// violation; the certificate must agree with what is recomputed (clearance to 1e-4 m, the rest to
/// 1e-9, see pipeline/verify/certificate.hpp). In the order of samples, then of causes and
/// subjects. What a grasp says of friction, mass, torques and stiffness is held against the
/// effective config, what the plan says of tolerances, home and scene against what was asked, where
/// these are given.
MORPHE_EXPORT std::vector<Violation> verify_plan(const RobotTable& robot,
                                                 const std::string& plan_path, const Plan& plan,
                                                 const std::string& config = {},
                                                 const Asked* asked = nullptr);

/// What a file asks for, by its header; InputError where that cannot be told.
using AskedOf = std::function<Asked(const PlanFileHeader&)>;

/// Every plan of a plans.h5, of which there must be one, and the robot's table; without `asked_of`
/// nothing of it is held against the file's config and inputs. On `jobs` threads, with the same
/// report. Throws InputError if the file cannot be read.
MORPHE_EXPORT VerifyReport verify_file(const std::filesystem::path& file,
                                       const AskedOf& asked_of = {}, int jobs = 1);

/// {executable, approximate, infeasible, violations: [{plan, sample, time_s, cause, subject, value,
/// limit, unit}]}; a number that is not finite is null.
MORPHE_EXPORT std::string verify_json(const VerifyReport& report);

/// A line per violation, then the sum.
MORPHE_EXPORT std::string verify_text(const VerifyReport& report);

}  // namespace morphe::verify
