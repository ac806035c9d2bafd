#pragma once

#include <string>
#include <vector>

#include "core/config/fields.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::study {

struct AngleFile {
  std::string recording, file;
};
template <class Fields>
void fields(Fields& f, AngleFile& o) {
  f.required("recording", o.recording);
  f.required("file", o.file);
}

/// Recordings that somebody marked.
struct RealSet {
  std::string name, manifest;
  bool same_boundaries = false;   ///< the labels are what segmentation calls a boundary
  std::vector<AngleFile> angles;  ///< joint angles of others (see angle_files.hpp)
};
template <class Fields>
void fields(Fields& f, RealSet& o) {
  f.required("name", o.name);
  f.required("manifest", o.manifest);
  f("same_boundaries", o.same_boundaries);
  f("angles", o.angles);
}

/// Recordings made by pipeline/synthesize.
struct SyntheticSet {
  std::string name, config;
  int count = 500, quick_count = 20;
  std::uint64_t seed = 1;
  std::vector<std::string> set;              ///< "a.b=value" on the config
  double least_recall = 0;                   ///< what is asked for, 0 = nothing
  double median_s = 0, percentile_95_s = 0;  ///< of boundary errors
  bool accuracy = false;                     ///< positions are judged too
  double joints_m = 0, fingertips_m = 0;     ///< rms asked of elbow and wrist, and of fingertips
};
template <class Fields>
void fields(Fields& f, SyntheticSet& o) {
  f.required("name", o.name);
  f.required("config", o.config);
  f("count", o.count);
  f("quick_count", o.quick_count);
  f("seed", o.seed);
  f("set", o.set);
  f("least_recall", o.least_recall);
  f("median_s", o.median_s);
  f("percentile_95_s", o.percentile_95_s);
  f("accuracy", o.accuracy);
  f("joints_m", o.joints_m);
  f("fingertips_m", o.fingertips_m);
}
std::string why_invalid(const SyntheticSet& set);

/// configs/studies/recordings.yaml.
struct RecordingsStudyOptions {
  std::string study;
  std::vector<RealSet> real;
  std::vector<SyntheticSet> synthetic;
  reconstruct::ReconstructOptions reconstruct;
  reconstruct::HumanOptions human;
  segment::SegmentOptions segment;
};
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
