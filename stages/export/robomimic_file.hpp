#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/plan.hpp"

namespace morphe::exports {

/// N > 0 transitions of one motion: observation k, action k, observation k + 1.
struct RobomimicDemo {
  std::string plan;                                             ///< <demonstration>/<000>
  std::string subject, task, status;                            ///< of the plan
  JointRows actions;                                            ///< [N, n], unscaled
  std::vector<std::pair<std::string, JointRows>> observations;  ///< each [N + 1, …]
  Grasp grasp;                                                  ///< written if it has contacts
  std::string joint_unit;                                       ///< unit of the grasp's postures
  std::vector<RecordingFlag> flags;                             ///< doubts about the recording
  std::vector<PhaseKind> phase;                                 ///< [N + 1] of the observations
  bool is_valid = false;                                        ///< for validation
};

/// The data common to all demonstrations of a file. Actions are scaled from [lower, upper] to [-1,
/// 1]: actions_abs = offset + scale * actions, offset = (lower + upper) / 2, scale = upper -
/// offset.
struct RobomimicHeader {
  std::string env_args;                   ///< JSON: env_name, type, env_kwargs
  std::vector<std::string> action_names;  ///< [n] names of the joints
  JointVector lower, upper;               ///< [n] finite, lower <= upper
  std::string not_verified;               ///< as in ExportOptions
};

/// Writes a dataset as robomimic reads it: /data/demo_0 … with @num_samples, actions, actions_abs,
/// obs/, next_obs/, rewards and dones (1 at the last transition), and the phases as segments in
/// phases/: @names, begin and end (indices of the first transition and of that after the last one);
/// /mask/train and /mask/valid; and
/// for grasps with contacts /grasps/demo_0 …, in the layout of grasp/ in plans.h5, which robomimic
/// ignores. The dataset is written to `part`, which must outlive the writer, and is complete after
/// finish().
class RobomimicWriter {
 public:
  RobomimicWriter(const files::AtomicFile& part, const RobomimicHeader& header);
  ~RobomimicWriter();
  void add(const RobomimicDemo& demo);  ///< appends a demonstration
  void finish();                        ///< completes the file

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace morphe::exports
