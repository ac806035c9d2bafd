#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::fuzz {

/// A parser, or another that reads what strangers wrote. `read` takes a file's bytes; InputError is
/// as it should be, whatever else it throws is a fault.
struct Target {
  std::string name;
  std::function<void(std::string_view)> read;
  bool in_child = false;  ///< a library of others reads first, in a child process
};

std::vector<Target> text_targets();  ///< YAML, URDF, MJCF, planning scenes, manifests, STL, meshes
std::vector<Target> recording_targets();  ///< a target a format: "import-vicon-csv", …
std::vector<Target> store_targets();      ///< a journal's bytes, plans.h5, demonstrations.h5
std::vector<Target> verify_targets();     ///< an honest plan, with numbers of it changed

std::vector<Target> all_targets();
std::optional<Target> target_named(std::string_view name);

/// The bytes as a file of that name, the same for every call.
std::filesystem::path as_file(std::string_view bytes, const std::string& name);

}  // namespace morphe::fuzz
