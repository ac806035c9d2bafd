#pragma once

#include <vector>

#include "stages/import/audit/label_search.hpp"

namespace morphe::imports {

/// Frames in which the tracks keep their columns, up to those of the next part.
struct LabelPart {
  std::size_t begin = 0;
  Permutation source;  ///< columns of the tracks in the recording
};

/// The tracks of a recording under their own names, and in which columns they were recorded.
struct LabelTimeline {
  Array2D<Vec3> tracks;          ///< [frame, name]
  std::vector<LabelPart> parts;  ///< the first begins at frame 0

  /// Returns the first frame behind a part.
  std::size_t end_of(std::size_t part) const;
  /// Gives the track of `source[k]` the name k in the frames from `begin` to `end`.
  void relabel(std::size_t begin, std::size_t end, const Permutation& source);
};

/// Returns the timeline in which the tracks go on after the exchanges and all carry the names that
/// they have at the beginning.
LabelTimeline continued_tracks(const std::vector<double>& time, const Array2D<Vec3>& position);

/// Returns the timeline of joints: tracks go on after exchanges, whole joints are given the order
/// of shortest_chain(), and the tips of thumb and index finger that of digit_order().
LabelTimeline find_joint_labels(const std::vector<double>& time, const Array2D<Vec3>& position,
                                const std::vector<std::string>& names);

/// Returns the timeline with the names that fit best:
/// 1. Tracks that change places go on. Of the names before and after, those are right that fit the
///    clusters and the hand; if both fit, those before.
/// 2. Whole clusters get the order of shortest_chain().
/// 3. Frames after a gap in which a cluster does not fit, but does in the others, are relabelled as
///    find_relabelling() finds.
/// 4. So is the whole recording, and then again frames after a gap.
/// 5. The tips of thumb and index finger get the order that digit_order() finds.
LabelTimeline find_labels(const MarkerStream& markers,
                          const std::optional<MarkerStream>& static_trial);

}  // namespace morphe::imports
