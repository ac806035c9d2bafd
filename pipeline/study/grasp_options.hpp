#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pipeline/study/variant.hpp"

namespace morphe::study {

/// A set of recordings and the hands that grasp the objects in them.
struct GraspSet {
  /// The name of the set.
  std::string name;
  /// One config for each hand.
  std::vector<std::string> pipelines;
  /// Manifest of real recordings, which come first.
  std::string manifest;
  /// Config of pipeline/synthesize for synthetic recordings.
  std::string synthetic;
  /// True if an object is put into the hand of each synthetic recording
  /// (pipeline/study/held_objects.hpp).
  bool known_objects = false;
  /// Number of synthetic recordings; recordings of the manifest are limited only with --quick.
  int count = 50, quick_count = 1;
  /// The seed of the synthetic recordings.
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
  f("count", o.count);
  f("quick_count", o.quick_count);
  f("seed", o.seed);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const GraspSet& set);

/// The options of configs/studies/grasp.yaml. Each recording is planned twice, with contacts as
/// goals and with plain fingertip goals; the contacts of the robot are compared with those of the
/// person.
struct GraspStudyOptions {
  /// The name of the study.
  std::string study;
  /// The sets of recordings.
  std::vector<GraspSet> sets;
  /// Variant with contacts, which must have a section `grasp`.
  StudyVariant contacts;
  /// Baseline without a section `grasp`.
  StudyVariant fingertips;
  /// Number of hands of a set in the quick variant, taken from the first.
  int quick_hands = 1;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, GraspStudyOptions& o) {
  f.required("study", o.study);
  f.required("sets", o.sets);
  f.required("contacts", o.contacts);
  f.required("fingertips", o.fingertips);
  f("quick_hands", o.quick_hands);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const GraspStudyOptions& options);

}  // namespace morphe::study
