#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stages/import/guess/body_guess.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

/// What would make a recording readable, computed from its data.
struct Proposal {
  std::vector<std::pair<std::string, std::string>> names;  ///< recorded -> ours; empty = as given
  std::vector<std::pair<std::string, Guess>> conventions;  ///< by key: "axes", "unit", …
};

/// All that a recording leaves open, at once: what() has a line for each thing.
struct ImportQuestion : InputError {
  ImportQuestion(const std::string& message) : InputError(message) {}
  std::string file;
  std::string manifest;  ///< that lists it; "" = given directly
  std::string survey;    ///< lines that show what the file holds and what it was taken for
  Proposal proposal;     ///< was tried: with it the recording is read
  std::optional<Demonstration> without_names;  ///< what was read, if names alone are open
  bool names_open = false;  ///< no name is known, and none of an arm could be proposed
};

/// Reads one recording. Where no name in it is one of Morphe's and none is mapped, the shipped name
/// map that fits is used, and said. ImportQuestion for axes, unit, rate and names that are missing
/// or cannot be right; names are asked for where those of an arm can be proposed. InputError for
/// everything else.
Demonstration read_or_ask(const RecordingFormat& format, const RecordingFiles& files,
                          const std::string& manifest);

}  // namespace morphe::imports
