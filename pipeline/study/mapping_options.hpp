#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// Recordings that one pipeline config plans.
struct MappingSet {
  std::string name, pipeline;
  std::string manifest;   ///< real recordings, or
  std::string synthetic;  ///< a config of pipeline/synthesize
  int count = 50, quick_count = 1;
  std::uint64_t seed = 1;
};
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
std::string why_invalid(const MappingSet& set);

/// configs/studies/mapping.yaml: the whole pipeline over recordings, by several variants of its
/// config. The first variant is ours; the others are compared with it.
struct MappingStudyOptions {
  std::string study;
  std::vector<MappingSet> sets;
  std::vector<StudyVariant> variants;
  std::string best;     ///< variant that searches longest: the best continuous sequence known
  std::string without;  ///< variant without humanlikeness
  /// A frame lies above the best sequence if its F is larger by more than this, F with the weights
  /// of the set's pipeline and this one for tip positions.
  double excess = 1e-3;
  double tip_position = 1000;  ///< w_x [1/m²]
};
template <class Fields>
void fields(Fields& f, MappingStudyOptions& o) {
  f.required("study", o.study);
  f.required("sets", o.sets);
  f.required("variants", o.variants);
  f("best", o.best);
  f("without", o.without);
  f("excess", o.excess);
  f("tip_position", o.tip_position);
}
std::string why_invalid(const MappingStudyOptions& options);

}  // namespace morphe::study
