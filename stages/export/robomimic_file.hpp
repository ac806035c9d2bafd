#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/files/part_file.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/plan.hpp"

namespace morphe::exports {

/// N transitions of one motion: observation k, action k, observation k + 1.
struct RobomimicDemo {
  std::string plan, subject, task;
  std::string status;                                           ///< executable or approximate
  JointRows actions;                                            ///< [N, n], not scaled
  std::vector<std::pair<std::string, JointRows>> observations;  ///< each [N + 1, …]
  Grasp grasp;                                                  ///< written if it names contacts
  std::string joint_unit;                                       ///< of its postures
};

/// What all demonstrations of a file share. actions_abs = offset + scale * actions puts
/// [low, high] onto [-1, 1].
struct RobomimicHeader {
  std::string env_args;  ///< JSON: env_name, type, env_kwargs
  std::vector<std::string> action_names;
  JointVector low, high;  ///< [n] finite, low <= high
};

/// A dataset as robomimic reads it: /data/demo_0 … with @num_samples, actions, actions_abs, obs/,
/// next_obs/, rewards and dones (1 at the last transition); /mask/train and /mask/valid; and
/// /grasps/demo_N, as grasp/ of a plans.h5, which robomimic does not look at. It is
/// written as the part of a file that must outlive the writer, and is whole after finish().
class RobomimicWriter {
 public:
  RobomimicWriter(const files::PartFile& part, const RobomimicHeader& header);
  ~RobomimicWriter();
  void add(const RobomimicDemo& demo);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Every tenth demonstration, at least one of two, evenly spread.
std::vector<std::size_t> validation_demos(std::size_t count);

}  // namespace morphe::exports
