#pragma once

/// Morphe as a library: recordings -> demonstrations.h5 -> plans -> plans.h5, and the verification
/// of plans (docs/library.md). Units are SI (m, s, rad); values that were not observed are NaN.
///
/// All errors in a file, a config or an argument are thrown as InputError, with one line that names
/// the file, line and key. Files to be read are searched at the given path, and then among those
/// that were installed with Morphe (configs/…, datasets/…).

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/export.hpp"
#include "core/motion/input_error.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/residual_term.hpp"
#include "core/motion/robot_model.hpp"
#include "core/motion/version.hpp"
#include "core/store/demonstration_file.hpp"
#include "core/store/plan_file.hpp"
#include "stages/verify/verify.hpp"

namespace morphe {

/// A pipeline config with the robot and the scene to which it refers. Copies share the same state.
class MORPHE_EXPORT Pipeline {
 public:
  /// Loads the config. `settings` are "a.b=value": each replaces a value of the config. `terms` are
  /// added to the objective with the weights given by the config's `map.custom_terms`.
  explicit Pipeline(const std::filesystem::path& config,
                    const std::vector<std::string>& settings = {},
                    const std::vector<std::shared_ptr<const ResidualTerm>>& terms = {});

  /// Plans every movement of the demonstration. Returns the plans in order, executable or with the
  /// reason for the failure, bitwise equal to those of `morphe run`. It may be called from several
  /// threads at once. Throws for a demonstration that cannot be processed at all.
  std::vector<Plan> plan(const Demonstration& demonstration) const;

  /// Returns the header of a plans.h5 with this pipeline's plans of a demonstrations.h5.
  PlanFileHeader header(const std::filesystem::path& demonstrations) const;

  /// Returns the robot of the config.
  const RobotModel& robot() const;
  /// Returns the demonstrations.h5 or the recordings that the config names, "" if it names none.
  const std::filesystem::path& dataset() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// Converts a recording, or a manifest (.yaml) of recordings. Returns the number of demonstrations.
MORPHE_EXPORT std::size_t import_recordings(const std::filesystem::path& recordings,
                                            const std::filesystem::path& demonstrations);

/// Loads a robot description (docs/formats.md): DH chains, a URDF, a generated robot, or parts.
MORPHE_EXPORT RobotModel load_robot(const std::filesystem::path& description);

/// Verifies every plan of a plans.h5 as `morphe verify` does: against its certificate and, which
/// verify::verify_file alone does not, against the requirements of its own config and inputs.
MORPHE_EXPORT verify::VerifyReport verify_plans(const std::filesystem::path& plans);

}  // namespace morphe
