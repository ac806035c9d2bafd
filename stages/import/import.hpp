#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "pipeline/motion/demonstration.hpp"
#include "stages/import/conventions.hpp"

namespace morphe::imports {

/// What to read. A path is a recording or a manifest (.yaml, see manifest.hpp) that lists several.
struct ImportRequest {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path static_trial;  ///< for recordings given directly; empty = none
  std::string format;                  ///< one of import_format_names(); "" = by content
  std::filesystem::path names;         ///< YAML map "recorded name: name used here"; empty = none
  Conventions conventions;             ///< for recordings given directly
};

/// Reads every recording and hands it to the sink, in the order of the request; returns how many.
/// One recording is held at a time. Throws InputError "FILE:LINE: KEY: message" (KEY is a column
/// for CSV) for anything that is not exactly what its format says, and for names that repeat.
std::size_t import_recordings(const ImportRequest& request,
                              const std::function<void(Demonstration&&)>& sink);

/// The same into a demonstrations.h5 (pipeline/store/demonstration_file.hpp); `seen` is shown each.
std::size_t write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                                 const std::function<void(const Demonstration&)>& seen = {});

std::vector<std::string> import_format_names();

}  // namespace morphe::imports
