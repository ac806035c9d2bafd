#include "pipeline/setup/mesh_paths.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

/// Returns the folder of a file and those above it, without the root of the file system.
std::vector<fs::path> folders_above(const fs::path& file) {
  std::vector<fs::path> folders;
  for (fs::path folder = fs::absolute(file).lexically_normal().parent_path();
       folder.has_relative_path(); folder = folder.parent_path())
    folders.push_back(folder);
  return folders;
}

fs::path find_in_package(const std::vector<fs::path>& folders, const std::string& name,
                         const fs::path& path) {
  for (const fs::path& folder : folders) {
    if (folder.filename() == name && is_file(folder / path)) return folder / path;
    for (const char* sub : {"", "src", "share"}) {
      if (const fs::path file = folder / sub / name / path; is_file(file)) return file;
    }
    if (is_file(folder / path)) return folder / path;
  }
  return {};
}

/// Returns the longest end of a path that exists in one of the folders, with that folder.
fs::path find_tail(const std::vector<fs::path>& folders, const fs::path& path) {
  fs::path tail;
  for (const fs::path& part : path.lexically_normal().relative_path())
    if (part != "..") tail /= part;
  while (!tail.empty()) {
    for (const fs::path& folder : folders)
      if (is_file(folder / tail)) return folder / tail;
    fs::path shorter;
    for (auto part = std::next(tail.begin()); part != tail.end(); ++part) shorter /= *part;
    tail = shorter;
  }
  return {};
}

/// Splits `package://NAME/PATH`, `model://NAME/PATH` and xacro's `$(find NAME)/PATH` into NAME and
/// PATH; NAME is "" for other names. Backslashes become slashes.
std::pair<std::string, std::string> split_package(std::string name) {
  std::ranges::replace(name, '\\', '/');
  if (name.starts_with("file://")) return {"", name.substr(7)};
  for (const auto& [scheme, end] :
       {std::pair<std::string_view, std::string_view>{"package://", "/"},
        {"model://", "/"},
        {"$(find ", ")/"}}) {
    if (!name.starts_with(scheme)) continue;
    const std::string rest = name.substr(scheme.size());
    const std::size_t at = rest.find(end);
    if (at == rest.npos) return {rest, ""};
    return {rest.substr(0, at), rest.substr(at + end.size())};
  }
  return {"", name};
}

}  // namespace

MeshPlace find_mesh(const fs::path& urdf, const std::string& name, const PackagePaths& places) {
  MeshPlace place;
  const auto [package, path] = split_package(name);
  place.package = package;
  std::vector<fs::path> folders = folders_above(urdf);
  if (const auto given = places.packages.find(package); given != places.packages.end()) {
    folders = {given->second};
    if (is_file(given->second / path)) place.file = given->second / path;
  } else if (!package.empty()) {
    place.file = find_in_package(folders, package, path);
  } else if (is_file(urdf.parent_path() / path)) {
    place.file = urdf.parent_path() / path;  // also of a path that is absolute
  }
  if (!place.file.empty()) return place;
  place.file = find_tail(folders, path);
  place.by_tail = !place.file.empty();
  return place;
}

}  // namespace morphe::setup
