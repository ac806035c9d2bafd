#pragma once

#include <string>
#include <vector>

#include "core/config/fields.hpp"
#include "core/motion/key_bounds.hpp"
#include "core/solve/minimise.hpp"

namespace morphe::study {

/// The options of configs/studies/paper*.yaml, which reproduce results of the paper per frame,
/// without a scene.
struct PaperStudyOptions {
  std::string study;
  std::string arm_motions;   ///< manifest with shoulder, elbow and wrist, for arms
  std::string tip_motions;   ///< manifest with five fingertips at a wrist, for arms with hands
  std::string hand_motions;  ///< manifest with finger angles, for hands alone
  std::string robots;        ///< folder of the descriptions of PA10, DLR/HIT II and WAM
  /// The dimensions of the human: mean of the 50th percentile man and woman [m].
  double upper_arm = 0.323, forearm = 0.254, hand_length = 0.187, hand_breadth = 0.083;
  double hand_scale = 1.1;  ///< size of robot hands relative to the human's
  /// The weights of every case that does not set its own [1/m²], [1/rad of half the angle], [1/m²].
  double tip_position = 1e6, tip_orientation = 10, humanlike = 1;
  solve::MinimiseOptions solver;
  int starts = 32;  ///< number of starts at each of three key frames per movement
  double step_s = 0.05, quick_step_s = 0.2;  ///< time step of the frames [s]
  std::vector<std::string> cases;            ///< results of the study to compute, empty for all
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, PaperStudyOptions& o) {
  f.required("study", o.study);
  f.required("arm_motions", o.arm_motions);
  f.required("tip_motions", o.tip_motions);
  f.required("hand_motions", o.hand_motions);
  f.required("robots", o.robots);
  f("upper_arm", o.upper_arm, bounds::kBone);
  f("forearm", o.forearm, bounds::kBone);
  f("hand_length", o.hand_length, bounds::kBone);
  f("hand_breadth", o.hand_breadth, bounds::kBone);
  f("hand_scale", o.hand_scale, bounds::kFactor);
  f("tip_position", o.tip_position, bounds::kWeight);
  f("tip_orientation", o.tip_orientation, bounds::kWeight);
  f("humanlike", o.humanlike, bounds::kWeight);
  f("solver", o.solver);
  f("starts", o.starts, bounds::kSearchCount);
  f("step_s", o.step_s, bounds::kTimeStep);
  f("quick_step_s", o.quick_step_s, bounds::kTimeStep);
  f("cases", o.cases);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const PaperStudyOptions& options);

}  // namespace morphe::study
