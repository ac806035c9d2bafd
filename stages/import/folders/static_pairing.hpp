#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stages/import/folders/recording_descriptor.hpp"

namespace morphe::imports {

/// The static trial that belongs to a recording.
struct StaticPair {
  int static_index = 0;     ///< index in `statics`
  std::string person;       ///< as in the recording's name or folder; "" if not matched by name
  int candidate_count = 1;  ///< number of static trials that would have matched
};

/// Returns for each recording its static trial among `statics`; no value if there is no match. A
/// static trial matches if it has the recording's format and three of its points (all, if the
/// recording has fewer), and belongs to the same person:
/// - If its name begins with a person's ("ADL001_static"), as names and folders of recordings show,
///   so must the recording's name, or one of its folders must have the person's name.
/// - Otherwise the recording must have all folders of the static trial (P01 in static/P01/… and
///   reach/P01/…), apart from those named like a static trial ("Static", "calib").
/// A name with the number of another person ("ADL002DR1") never matches. Of several, the one with
/// most folders in common is chosen, then the one with the longest name of a person, the same
/// subject in the file, most points and most words of its name in common, and finally the first.
std::vector<std::optional<StaticPair>> pair_static_trials(
    const std::vector<RecordingDescriptor>& recordings,
    const std::vector<RecordingDescriptor>& statics);

}  // namespace morphe::imports
