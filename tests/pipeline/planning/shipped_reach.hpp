#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "stages/import/import.hpp"

namespace morphe::planning {

/// A shipped recording of the UE_ADL database, with its person's static trial.
inline Demonstration shipped_reach(const std::string& name, imports::ForwardSource forward) {
  const std::filesystem::path folder = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl";
  imports::ImportRequest request;
  request.paths = {folder / (name + ".csv")};
  request.static_trial = folder / (name.substr(0, 6) + "_static.csv");
  request.conventions.forward = forward;
  std::vector<Demonstration> all;
  imports::import_recordings(request, [&](Demonstration&& d) { all.push_back(std::move(d)); });
  return all.at(0);
}

}  // namespace morphe::planning
