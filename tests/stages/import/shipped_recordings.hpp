#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "stages/import/import.hpp"

namespace morphe::imports {

/// The recordings of a folder of datasets/, in the recorded axes, whichever way the person faces.
inline std::vector<Demonstration> shipped_recordings(const std::string& folder) {
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets" / folder /
                   "recordings.yaml"};
  std::vector<Demonstration> all;
  import_recordings(request, [&](Demonstration&& d) { all.push_back(std::move(d)); });
  return all;
}

}  // namespace morphe::imports
