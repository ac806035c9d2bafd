#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/motion/assumption_text.hpp"
#include "core/motion/export.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/plan_request.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/verify/violation.hpp"

namespace morphe::verify {

/// What a verification compared, beside the plans' curves and certificates.
struct LookedAt {
  bool inputs = false;      ///< robot, config and plans with the file's own inputs
  bool recordings = false;  ///< plans with the recordings of which they are
};

/// The violations found in a file and the number of its plans by status.
struct VerifyReport {
  int executable = 0, approximate = 0, partial = 0,
      infeasible = 0;  ///< plans, by their stored status
  std::vector<Violation> violations;
  std::vector<Assumption> assumptions;  ///< of the file
  AssumptionTally plan_assumptions;     ///< of its plans with a trajectory
  LookedAt looked_at;
};

/// Verifies one plan against the guarantees of docs/formats.md, with an independent implementation.
/// Limits are checked along the quintic between samples (exact extrema). Clearance and the distance
/// of tips from their goals are proved there by bisection. Intervals that remain undecided when no
/// body moves more than 0.01 mm count as violations. The certificate must agree with the recomputed
/// one (certificate.hpp). Friction, mass, torques and stiffness of a grasp are compared with the
/// effective `config`, tolerances, home and scene with the `request`, if these are given. Returns
/// the violations of the trajectory sorted by sample, cause and subject, then those of the approach
/// and of the retreat. `plan_path` is the plan's name in them.
MORPHE_EXPORT std::vector<Violation> verify_plan(const RobotModel& robot,
                                                 const std::string& plan_path, const Plan& plan,
                                                 const std::string& config = {},
                                                 const PlanRequest* request = nullptr);

/// Compares what a plan takes from its recording with `expected`, which was made from the recording
/// anew (`recording`; value: the largest deviation, limit 1e-6): names, flags, assumptions, phases
/// and times, the scene, the reference frames and the goals. Goals of tips that contacts may have
/// changed are left out: with the section `grasp`, those since the preshape or 0.5 s before the
/// grasp. Violations are sorted by subject.
MORPHE_EXPORT std::vector<Violation> verify_recorded(const std::string& plan_path,
                                                     const Plan& stored, const Plan& expected);

/// Returns a file's request from its header; throws InputError if it cannot be determined.
using RequirementsReader = std::function<PlanRequest(const PlanFileHeader&)>;

/// Verifies every plan of a plans.h5, of which there must be at least one, and that the file has
/// nothing but what its format has. With `read_request`, the
/// robot's table and the plans are compared with the request, too. Runs on `jobs` threads, with the
/// same report for any number. Throws InputError if the file cannot be read.
MORPHE_EXPORT VerifyReport verify_file(const std::filesystem::path& file,
                                       const RequirementsReader& read_request = {}, int jobs = 1);

/// Returns the report as JSON: {executable, approximate, partial, infeasible, violations: [{plan,
/// sample, time_s, cause, subject, value, limit, unit}], assumptions: [{kind, subject, value,
/// plans}], looked_at: {file, curves, inputs, recordings}}; a number that is not finite is null,
/// and so is `plans` for an assumption of the whole file.
MORPHE_EXPORT std::string verify_json(const VerifyReport& report);

/// Returns a violation as one line, such as "reach/000: plan: mapped status: 1, limit 0".
MORPHE_EXPORT std::string violation_text(const Violation& violation);

/// Returns the report as text: one line per violation, what the verification holds for and on what
/// it rests, and the totals.
MORPHE_EXPORT std::string verify_text(const VerifyReport& report);

}  // namespace morphe::verify
