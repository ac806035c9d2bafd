#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/config/fields.hpp"

namespace morphe::study {

/// A hand of the study, and what its vendor's or peers' setup says of it.
struct StudiedHand {
  std::string file;             ///< a robot description without an arm
  std::string origin;           ///< frame from which the peers' vectors point; "": the palm
  std::optional<double> scale;  ///< theirs of the human hand; none: what ours finds
  bool pads_meet = true;        ///< whether thumb and index can be brought pad to pad
};
template <class Fields>
void fields(Fields& f, StudiedHand& o) {
  f.required("file", o.file);
  f("origin", o.origin);
  f("scale", o.scale);
  f("pads_meet", o.pads_meet);
}
std::string why_invalid(const StudiedHand& hand);

/// configs/studies/hands.yaml.
struct HandsStudyOptions {
  std::string study;
  std::string pipeline;             ///< its robot is replaced by each of the hands
  std::string manifest;             ///< recordings of hands alone
  std::vector<StudiedHand> robots;  ///< one after the other
  double near_m = 0.04;             ///< human's thumb-index distance below which it is a pinch
  int quick_robots = 1;             ///< hands that the quick variant looks at, the first ones
  int quick_frames = 300;           ///< and frames of it, with the peers' objectives
};
template <class Fields>
void fields(Fields& f, HandsStudyOptions& o) {
  f.required("study", o.study);
  f.required("pipeline", o.pipeline);
  f.required("manifest", o.manifest);
  f.required("robots", o.robots);
  f("near", o.near_m);
  f("quick_robots", o.quick_robots);
  f("quick_frames", o.quick_frames);
}
std::string why_invalid(const HandsStudyOptions& options);

}  // namespace morphe::study
