#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// A set of recordings and the hands that grasp the objects in them.
struct GraspSet {
  std::string name;
  std::vector<std::string> pipelines;  ///< one config for each hand
  std::string manifest;                ///< manifest of real recordings, which come first
  std::string synthetic;               ///< config of pipeline/synthesize
  bool known_objects = false;  ///< puts an object into each synthetic hand (held_objects.hpp)
  /// Number of synthetic recordings; recordings of the manifest are limited only with --quick.
  int count = 50, quick_count = 1;
  std::uint64_t seed = 1;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, GraspSet& o) {
  f.required("name", o.name);
  f.required("pipelines", o.pipelines);
  f("manifest", o.manifest);
  f("synthetic", o.synthetic);
  f("known_objects", o.known_objects);
  f("count", o.count, bounds::kCount);
  f("quick_count", o.quick_count, bounds::kCount);
  f("seed", o.seed);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const GraspSet& set);

/// The options of configs/studies/grasp.yaml. Each recording is planned twice, with contacts and
/// with fingertips as goals; the contacts of the robot are compared with those of the person.
struct GraspStudyOptions {
  std::string study;
  std::vector<GraspSet> sets;
  StudyVariant contacts;    ///< variant with contacts, which must have a section `grasp`
  StudyVariant fingertips;  ///< baseline without a section `grasp`
  int quick_hands = 1;      ///< number of hands of a set in the quick variant, taken from the first
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, GraspStudyOptions& o) {
  f.required("study", o.study);
  f.required("sets", o.sets);
  f.required("contacts", o.contacts);
  f.required("fingertips", o.fingertips);
  f("quick_hands", o.quick_hands, bounds::kCount);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const GraspStudyOptions& options);

}  // namespace morphe::study
