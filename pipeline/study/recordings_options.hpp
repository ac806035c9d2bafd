#pragma once

#include <string>
#include <vector>

#include "core/config/fields.hpp"
#include "core/motion/key_bounds.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::study {

/// A recording and the file with its joint angles.
struct AngleFile {
  std::string recording, file;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, AngleFile& o) {
  f.required("recording", o.recording);
  f.required("file", o.file);
}

/// A set of real recordings with annotated movements.
struct RealSet {
  std::string name, manifest;
  /// True if the labels use the same definition of boundaries as segmentation.
  bool same_boundaries = false;
  /// Joint angles from other software (see angle_files.hpp).
  std::vector<AngleFile> reference_angles;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, RealSet& o) {
  f.required("name", o.name);
  f.required("manifest", o.manifest);
  f("same_boundaries", o.same_boundaries);
  f("reference_angles", o.reference_angles);
}

/// A set of recordings made by pipeline/synthesize.
struct SyntheticSet {
  std::string name, config;
  int count = 500, quick_count = 20;  ///< number of recordings, in total and in the quick variant
  std::uint64_t seed = 1;
  std::vector<std::string> set;  ///< settings "a.b=value" applied to the config
  double min_recall = 0;         ///< required recall, 0 for no requirement
  /// Required median and 95th percentile of the boundary errors [s].
  double max_median_error_s = 0, max_p95_error_s = 0;
  bool score_positions = false;  ///< true if positions are evaluated as well
  /// Required rms of elbow and wrist, and of fingertips [m].
  double max_joint_rms_m = 0, max_fingertip_rms_m = 0;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, SyntheticSet& o) {
  f.required("name", o.name);
  f.required("config", o.config);
  f("count", o.count, bounds::kCount);
  f("quick_count", o.quick_count, bounds::kCount);
  f("seed", o.seed);
  f("set", o.set);
  f("min_recall", o.min_recall, bounds::kShare);
  f("max_median_error_s", o.max_median_error_s, bounds::kDuration);
  f("max_p95_error_s", o.max_p95_error_s, bounds::kDuration);
  f("score_positions", o.score_positions);
  f("max_joint_rms_m", o.max_joint_rms_m, bounds::kLength);
  f("max_fingertip_rms_m", o.max_fingertip_rms_m, bounds::kLength);
}

/// The options of configs/studies/recordings.yaml.
struct RecordingsStudyOptions {
  std::string study;
  std::vector<RealSet> real;
  std::vector<SyntheticSet> synthetic;
  reconstruct::ReconstructOptions reconstruct;
  reconstruct::HumanOptions human;
  segment::SegmentOptions segment;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, RecordingsStudyOptions& o) {
  f.required("study", o.study);
  f("real", o.real);
  f("synthetic", o.synthetic);
  f("reconstruct", o.reconstruct);
  f("human", o.human);
  f("segment", o.segment);
}

}  // namespace morphe::study
