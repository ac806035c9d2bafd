#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/config/fields.hpp"

namespace morphe {

/// A pipeline config with settings "a.b=value".
struct MappingVariant {
  std::string name;
  std::vector<std::string> set;
};
template <class Fields>
void fields(Fields& f, MappingVariant& o) {
  f.required("name", o.name);
  f("set", o.set);
}

/// Recordings that one pipeline config plans.
struct MappingSet {
  std::string name, pipeline;
  std::string manifest;   ///< real recordings, or
  std::string synthetic;  ///< a config of stages/synthesize
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
std::string check(const MappingSet& set);

/// configs/studies/mapping.yaml: the whole pipeline over recordings, by several variants of its
/// config. The first variant is ours; the others are compared with it.
struct MappingStudyOptions {
  std::string study;
  std::vector<MappingSet> sets;
  std::vector<MappingVariant> variants;
  std::string best;     ///< variant that searches longest: the best continuous sequence known
  std::string without;  ///< variant without humanlikeness
  double excess = 1e-3;
};
template <class Fields>
void fields(Fields& f, MappingStudyOptions& o) {
  f.required("study", o.study);
  f.required("sets", o.sets);
  f.required("variants", o.variants);
  f("best", o.best);
  f("without", o.without);
  f("excess", o.excess);
}
std::string check(const MappingStudyOptions& options);

}  // namespace morphe
