#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/config/fields.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::study {

/// A hand of the study with the parameters of its vendor's or of the published setup.
struct StudiedHand {
  std::string file;             ///< robot description without an arm
  std::string vector_origin;    ///< frame where the published methods' vectors begin, "": the palm
  std::optional<double> scale;  ///< their scale of the human hand; if absent, ours is used
  bool can_pinch = true;        ///< true if thumb and index can touch pad to pad
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, StudiedHand& o) {
  f.required("file", o.file);
  f("vector_origin", o.vector_origin);
  f("scale", o.scale, bounds::kFactor);
  f("can_pinch", o.can_pinch);
}

/// The options of configs/studies/hands.yaml.
struct HandsStudyOptions {
  std::string study;
  std::string pipeline;  ///< pipeline whose robot is replaced by each of the hands
  std::string manifest;  ///< manifest of recordings of hands alone
  std::vector<StudiedHand> robots;
  double pinch_distance = 0.04;  ///< human thumb-index distance below which a frame is a pinch [m]
  int quick_robots = 1;          ///< number of hands in the quick variant, taken from the first
  int quick_frames = 300;        ///< frames per hand for the published methods in the quick variant
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, HandsStudyOptions& o) {
  f.required("study", o.study);
  f.required("pipeline", o.pipeline);
  f.required("manifest", o.manifest);
  f.required("robots", o.robots);
  f("pinch_distance", o.pinch_distance, bounds::kPositiveLength);
  f("quick_robots", o.quick_robots, bounds::kCount);
  f("quick_frames", o.quick_frames, bounds::kCount.from(5));
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const HandsStudyOptions& options);

}  // namespace morphe::study
