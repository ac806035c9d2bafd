#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/motion/asked.hpp"
#include "core/motion/export.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"
#include "stages/verify/violation.hpp"

namespace morphe::verify {

struct VerifyReport {
  int executable = 0, approximate = 0, infeasible = 0;  ///< plans, as the file has them
  std::vector<Violation> violations;
};

/// Judges one plan by what docs/formats.md promises of it, with code of its own. Limits hold along
/// the quintic between samples (exact extrema); clearance and the way of tips from their goals are
/// proved there by bisection, and what stays open when nothing moves more than 0.01 mm counts as a
/// violation; the certificate must agree with what is recomputed (clearance to 1e-4 m, the rest to
/// 1e-9, see stages/verify/certificate.hpp). In the order of samples, then of causes and
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
