#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/config/fields.hpp"

namespace morphe::study {

/// A hand of the study with the parameters of its vendor's or of the published setup.
struct StudiedHand {
  /// Robot description without an arm.
  std::string file;
  /// Frame at which the vectors of the published methods begin, "" for the palm.
  std::string vector_origin;
  /// Their scale of the human hand; if absent, the scale found by our method is used.
  std::optional<double> scale;
  /// True if thumb and index can touch pad to pad.
  bool can_pinch = true;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, StudiedHand& o) {
  f.required("file", o.file);
  f("vector_origin", o.vector_origin);
  f("scale", o.scale);
  f("can_pinch", o.can_pinch);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const StudiedHand& hand);

/// The options of configs/studies/hands.yaml.
struct HandsStudyOptions {
  /// The name of the study.
  std::string study;
  /// Pipeline whose robot is replaced by each of the hands.
  std::string pipeline;
  /// Manifest of recordings of hands alone.
  std::string manifest;
  /// The hands, studied one after the other.
  std::vector<StudiedHand> robots;
  /// Thumb-index distance of the human below which a frame is a pinch [m].
  double pinch_distance = 0.04;
  /// Number of hands in the quick variant, taken from the first.
  int quick_robots = 1;
  /// Number of frames per hand in the quick variant with the published objectives.
  int quick_frames = 300;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, HandsStudyOptions& o) {
  f.required("study", o.study);
  f.required("pipeline", o.pipeline);
  f.required("manifest", o.manifest);
  f.required("robots", o.robots);
  f("pinch_distance", o.pinch_distance);
  f("quick_robots", o.quick_robots);
  f("quick_frames", o.quick_frames);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const HandsStudyOptions& options);

}  // namespace morphe::study
