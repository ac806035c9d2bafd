#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// A set of recordings that are planned with one pipeline config.
struct MappingSet {
  /// The name of the set and its pipeline config.
  std::string name, pipeline;
  /// Manifest of real recordings, or "" for synthetic ones.
  std::string manifest;
  /// Config of pipeline/synthesize.
  std::string synthetic;
  /// The number of recordings, in total and in the quick variant.
  int count = 50, quick_count = 1;
  /// The seed of the synthetic recordings.
  std::uint64_t seed = 1;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, MappingSet& o) {
  f.required("name", o.name);
  f.required("pipeline", o.pipeline);
  f("manifest", o.manifest);
  f("synthetic", o.synthetic);
  f("count", o.count);
  f("quick_count", o.quick_count);
  f("seed", o.seed);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const MappingSet& set);

/// The options of configs/studies/mapping.yaml: the whole pipeline is run over recordings by
/// several variants of its config. The first variant is ours; the others are compared with it.
struct MappingStudyOptions {
  /// The name of the study.
  std::string study;
  /// The sets of recordings.
  std::vector<MappingSet> sets;
  /// The variants of the config, ours first.
  std::vector<StudyVariant> variants;
  /// Variant with the longest search, which gives the best known continuous sequence.
  std::string reference_variant;
  /// Variant without humanlikeness.
  std::string ik_variant;
  /// The excess of F above which a frame counts as worse than the best sequence. F is computed with
  /// the weights of the set's pipeline and with `tip_position` as the weight of the tip positions.
  double excess_threshold = 1e-3;
  /// Weight w_x of the tip positions [1/m²].
  double tip_position = 1000;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, MappingStudyOptions& o) {
  f.required("study", o.study);
  f.required("sets", o.sets);
  f.required("variants", o.variants);
  f("reference_variant", o.reference_variant);
  f("ik_variant", o.ik_variant);
  f("excess_threshold", o.excess_threshold);
  f("tip_position", o.tip_position);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const MappingStudyOptions& options);

}  // namespace morphe::study
