#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/plan.hpp"

namespace morphe::exports {

/// N transitions of one motion: observation k, action k, observation k + 1.
struct RobomimicDemo {
  std::string plan, subject, task;
  std::string status;                                           ///< executable or approximate
  JointRows actions;                                            ///< [N, n], unscaled
  std::vector<std::pair<std::string, JointRows>> observations;  ///< each [N + 1, …]
  Grasp grasp;                                                  ///< written if it has contacts
  std::string joint_unit;                                       ///< unit of the grasp's postures
};

/// The data common to all demonstrations of a file. actions_abs = offset + scale * actions maps
/// [-1, 1] to [lower, upper].
struct RobomimicHeader {
  std::string env_args;                   ///< JSON: env_name, type, env_kwargs
  std::vector<std::string> action_names;  ///< [n] names of the joints
  JointVector lower, upper;               ///< [n] finite, lower <= upper
};

/// Writes a dataset as robomimic reads it: /data/demo_0 … with @num_samples, actions, actions_abs,
/// obs/, next_obs/, rewards and dones (1 at the last transition); /mask/train and /mask/valid; and
/// /grasps/demo_N, in the layout of grasp/ in plans.h5, which robomimic ignores. The dataset is
/// written to the part of an AtomicFile that must outlive the writer, and is complete after
/// finish().
class RobomimicWriter {
 public:
  RobomimicWriter(const files::AtomicFile& part, const RobomimicHeader& header);
  ~RobomimicWriter();
  /// Appends a demonstration.
  void add(const RobomimicDemo& demo);
  /// Completes the file.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the indices of the validation demonstrations: every tenth one, evenly distributed, and
/// at least one of two.
std::vector<std::size_t> validation_demos(std::size_t count);

}  // namespace morphe::exports
