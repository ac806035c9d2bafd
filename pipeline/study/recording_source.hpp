#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/config/fields.hpp"
#include "core/motion/demonstration.hpp"
#include "core/motion/key_bounds.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// Recordings of a study: real ones or synthetic ones.
struct RecordingSource {
  std::string manifest;             ///< manifest or folder of real recordings, or "" for synthetic
  std::string synthetic;            ///< config of pipeline/synthesize
  int count = 50, quick_count = 1;  ///< number of recordings, in total and in the quick variant
  std::uint64_t seed = 1;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, RecordingSource& o) {
  f("manifest", o.manifest);
  f("synthetic", o.synthetic);
  f("count", o.count, bounds::kCount);
  f("quick_count", o.quick_count, bounds::kCount);
  f("seed", o.seed);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const RecordingSource& source);

/// Reads or synthesizes the recordings. Files are relative to the study's config.
std::vector<Demonstration> load_recordings(const RecordingSource& source, const StudyRun& run);

}  // namespace morphe::study
