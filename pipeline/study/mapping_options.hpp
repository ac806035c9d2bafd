#pragma once

#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "pipeline/study/recording_source.hpp"
#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// A set of recordings that are planned with one pipeline config.
struct MappingSet {
  std::string name, pipeline;
  RecordingSource recordings;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, MappingSet& o) {
  f.required("name", o.name);
  f.required("pipeline", o.pipeline);
  fields(f, o.recordings);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const MappingSet& set);

/// The options of configs/studies/mapping.yaml: the whole pipeline is run over recordings by
/// several variants of its config. The first variant is ours; the others are compared with it.
struct MappingStudyOptions {
  std::string study;
  std::vector<MappingSet> sets;
  std::vector<StudyVariant> variants;  ///< variants of the config, ours first
  std::string reference_variant;       ///< variant with the longest search, to compare F with
  std::string ik_variant;              ///< variant without humanlikeness
  /// The excess of F over that of the best known sequence, above which a frame counts as worse. F
  /// has the weights of the set's pipeline, except that the tip positions have `tip_position`.
  double excess_threshold = 1e-3;
  double tip_position = 1000;  ///< weight w_x of the tip positions [1/m²]
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, MappingStudyOptions& o) {
  f.required("study", o.study);
  f.required("sets", o.sets);
  f.required("variants", o.variants);
  f("reference_variant", o.reference_variant);
  f("ik_variant", o.ik_variant);
  f("excess_threshold", o.excess_threshold, bounds::kWeight);
  f("tip_position", o.tip_position, bounds::kWeight);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const MappingStudyOptions& options);

}  // namespace morphe::study
