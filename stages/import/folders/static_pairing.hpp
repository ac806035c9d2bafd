#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/recording_descriptor.hpp"

namespace morphe::imports {

/// The static trial that belongs to a recording, and the reason for the match.
struct StaticPair {
  std::size_t static_index = 0;  ///< index of the static trial
  /// As written in the recording's name or folder; "" if it was not matched by name.
  std::string person;
  std::size_t candidate_count = 1;  ///< number of static trials that would have matched
};

/// Returns the static trial of each recording, or no value if no static trial matches it.
///
/// A static trial is in the folder of its person or session; folders of static trials ("Static",
/// "calib") are ignored. It applies to all recordings below that folder, including those in another
/// branch (static/P01/… and reach/P01/…). If its own name begins with a person's ("ADL001_static"),
/// it applies only to recordings whose name begins with it, or that are in a folder of that name,
/// and never to those with another number ("ADL002DR1"). Both must have the same format and share
/// markers. If there are several, the one of the nearest folder is chosen, then the one with the
/// longest name, with the same subject in the file, with the most markers in common, with the most
/// words in common, and finally the first.
std::vector<std::optional<StaticPair>> pair_static_trials(
    const std::vector<RecordingDescriptor>& recordings,
    const std::vector<RecordingDescriptor>& statics);

}  // namespace morphe::imports
