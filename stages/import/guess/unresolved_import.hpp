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
  /// Recorded names with ours; empty to keep them.
  std::vector<std::pair<std::string, std::string>> names;
  std::vector<std::pair<std::string, Guess>> conventions;  ///< by key: "axes", "unit", …
};

/// An error for all missing data of a recording at once; its message has a line for each of them.
struct UnresolvedImport : InputError {
  UnresolvedImport(const std::string& message) : InputError(message) {}
  std::string file;      ///< file of the recording
  std::string manifest;  ///< manifest that lists the recording; "" if given directly
  std::string summary;   ///< lines with the contents of the file and their interpretation
  Proposal proposal;     ///< tested: the recording can be read with it
  /// The recording read so far, if only names are missing.
  std::optional<Demonstration> demonstration;
  /// True if all names are unknown, and no names of an arm could be proposed.
  bool names_unresolved = false;
};

/// Reads one recording. If its names are neither Morphe's nor mapped, a matching shipped name map
/// is used and reported. Throws UnresolvedImport for axes, unit, rate and names that are missing or
/// implausible; names are requested if those of an arm can be proposed. Throws InputError for all
/// other errors.
Demonstration read_or_propose(const RecordingFormat& format, const RecordingFiles& files,
                              const std::string& manifest);

}  // namespace morphe::imports
