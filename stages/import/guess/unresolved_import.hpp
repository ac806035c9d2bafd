#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stages/import/guess/convention_guess.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// Values that make a recording readable, computed from its data.
struct Proposal {
  /// Pairs of a recorded name and Morphe's; empty if the recorded names are kept.
  std::vector<std::pair<std::string, std::string>> names;
  std::vector<std::pair<std::string, Guess>> conventions;  ///< by key: "axes", "unit", …
};

/// An error for all missing data of a recording at once; its message has a line for each of them.
struct UnresolvedImport : InputError {
  UnresolvedImport(const std::string& message) : InputError(message) {}
  /// Returns the same question with another message.
  UnresolvedImport with_message(const std::string& message) const;
  std::string file;          ///< the recording
  std::string manifest;      ///< manifest that lists the recording; "" if given directly
  std::string static_trial;  ///< its static trial, or ""
  std::optional<Side> hand;  ///< that was given or found, unless it is the right one
  Conventions given;         ///< those with which it was read
  std::string summary;       ///< lines with the contents of the file and their interpretation
  Proposal proposal;         ///< the recording was read with it as a test
  std::optional<Demonstration> demonstration;  ///< the recording, if only names are missing
  /// True if there is no name map, and neither the recorded nor the proposed names are an arm's.
  bool names_unresolved = false;
};

/// Reads a recording as its format does, without rows that repeat the time of the row before. All
/// other functions read recordings with it.
Demonstration read_distinct_rows(const RecordingFormat& format, const RecordingFiles& files);

/// Reads a recording without plausibility checks, in its own coordinates instead of those of the
/// convention `key` ("axes": x y z, "unit": metres), and of any that are missing.
Demonstration read_unchecked(const RecordingFormat& format, RecordingFiles files,
                             const std::string& key);

/// Reads one recording, which `manifest` ("" if none) lists. If its names are neither mapped nor an
/// arm's, a shipped name map that matches is used and reported. Throws UnresolvedImport for missing
/// or implausible conventions, and for missing names of an arm if they can be proposed; InputError
/// for all other errors.
Demonstration read_or_propose(const RecordingFormat& format, const RecordingFiles& files,
                              const std::string& manifest);

}  // namespace morphe::imports
