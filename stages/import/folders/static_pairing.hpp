#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/recording_sketch.hpp"

namespace morphe::imports {

/// The static trial that belongs to a recording, and how that was told.
struct StaticPair {
  std::size_t which = 0;   ///< of the static trials
  std::string person;      ///< as the recording's name or folder writes it; "" = not told by a name
  std::size_t choice = 1;  ///< of how many that would have fitted
};

/// For each recording its static trial, none where nothing says whose a static trial is.
///
/// A static trial lies in the folder of its person or session, folders of static trials ("Static",
/// "calib") left out of sight: it serves what lies below that folder, be it in another branch
/// (static/P01/… and reach/P01/…). If its own name begins with somebody's ("ADL001_static") it
/// serves only recordings whose name begins so, or that lie in a folder of that name, and never
/// those of another number ("ADL002DR1"). Both must be of one format and share markers. Of several
/// the one of the nearest folder, then of the longest name, of the same subject in the file, with
/// the most markers in common, with the most words in common, the first.
std::vector<std::optional<StaticPair>> pair_static_trials(
    const std::vector<RecordingSketch>& recordings, const std::vector<RecordingSketch>& statics);

}  // namespace morphe::imports
