#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// Recordings, and the hands that grasp what is grasped in them.
struct GraspSet {
  std::string name;
  std::vector<std::string> pipelines;  ///< a config a hand
  std::string manifest;                ///< real recordings, and then
  std::string synthetic;               ///< those of a config of pipeline/synthesize
  bool known_objects = false;          ///< with an object put into the hand of each synthetic one
                                       ///< (pipeline/study/held_objects.hpp)
  int count = 50, quick_count = 1;     ///< synthetic ones, of the manifest's only with --quick
  std::uint64_t seed = 1;
};
template <class Fields>
void fields(Fields& f, GraspSet& o) {
  f.required("name", o.name);
  f.required("pipelines", o.pipelines);
  f("manifest", o.manifest);
  f("synthetic", o.synthetic);
  f("known_objects", o.known_objects);
  f("count", o.count);
  f("quick_count", o.quick_count);
  f("seed", o.seed);
}
std::string why_invalid(const GraspSet& set);

/// configs/studies/grasp.yaml: each recording planned twice, with contacts as goals and with plain
/// fingertip goals; what touches is held against where the person touched.
struct GraspStudyOptions {
  std::string study;
  std::vector<GraspSet> sets;
  StudyVariant contacts;    ///< must have a section `grasp`
  StudyVariant fingertips;  ///< the baseline, without one
  int quick_hands = 1;      ///< hands of a set that the quick variant looks at, the first ones
};
template <class Fields>
void fields(Fields& f, GraspStudyOptions& o) {
  f.required("study", o.study);
  f.required("sets", o.sets);
  f.required("contacts", o.contacts);
  f.required("fingertips", o.fingertips);
  f("quick_hands", o.quick_hands);
}
std::string why_invalid(const GraspStudyOptions& options);

}  // namespace morphe::study
