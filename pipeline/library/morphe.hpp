#pragma once

/// Morphe as a library: recordings -> demonstrations.h5 -> plans -> plans.h5, and its judge.
/// docs/library.md shows all of it in one page. SI units (m, s, rad); what was not seen is NaN.
///
/// Whatever is wrong with a file, a config or an argument is thrown as InputError: one line that
/// says which file, line and key. A file to read is looked for as it is named, and then among those
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
#include "core/motion/robot_table.hpp"
#include "core/motion/version.hpp"
#include "core/store/demonstration_file.hpp"
#include "core/store/plan_file.hpp"
#include "stages/verify/verify.hpp"

namespace morphe {

/// A pipeline's config, with the robot and the scene that it names. Copies share one.
class MORPHE_EXPORT Pipeline {
 public:
  /// `settings` are "a.b=value": each replaces a value of the config. `terms` are added to the
  /// objective with the weights that the config's `map.terms` gives them.
  explicit Pipeline(const std::filesystem::path& config,
                    const std::vector<std::string>& settings = {},
                    const std::vector<std::shared_ptr<const ResidualTerm>>& terms = {});

  /// A plan for each movement of the demonstration, executable or with the reason why not, in
  /// their order; the same as `morphe run` makes, to the last bit. May be called from several
  /// threads at once. A demonstration that nothing can be made of throws.
  std::vector<Plan> plan(const Demonstration& demonstration) const;

  /// What a plans.h5 says of itself whose plans are this pipeline's of a demonstrations.h5.
  PlanFileHeader header(const std::filesystem::path& demonstrations) const;

  const RobotTable& robot() const;
  /// The demonstrations.h5 or the recordings that the config names, "" if it names none.
  const std::filesystem::path& dataset() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// Reads a recording, or a manifest (.yaml) of recordings, and writes a demonstrations.h5; returns
/// how many demonstrations there are.
MORPHE_EXPORT std::size_t import_recordings(const std::filesystem::path& recordings,
                                            const std::filesystem::path& demonstrations);

/// A robot description (docs/formats.md): DH chains, a URDF, a generated robot, or parts.
MORPHE_EXPORT RobotTable load_robot(const std::filesystem::path& description);

/// Every plan of a plans.h5 by what it promises, and by what its own config and inputs ask for, as
/// `morphe verify` judges it; verify::verify_file alone knows nothing of the latter.
MORPHE_EXPORT verify::VerifyReport verify_plans(const std::filesystem::path& plans);

}  // namespace morphe
