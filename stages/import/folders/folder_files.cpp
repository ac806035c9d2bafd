#include "stages/import/folders/folder_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <system_error>

#include "core/files/text_encoding.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

bool is_plain_text(const std::string& name) {
  return files::is_utf8(name) && std::ranges::none_of(name, [](char c) {
           return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
         });
}

struct FolderWalk {
  const fs::path& results;
  fs::path root;  ///< with links resolved
  FolderFiles found;
  std::set<fs::path> entered;  ///< folders with links resolved

  void skip(const fs::path& path, const std::string& why, bool failed = false) {
    found.left_out.push_back({path, why, failed});
  }

  void enter(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error) return skip(folder, error.message(), true);
    if (root.empty()) root = real;
    if (!entered.insert(real).second) {
      return skip(folder, fs::is_symlink(folder, error)
                              ? "link to a folder that was already searched"
                              : "folder that was already searched through a link to it");
    }
    std::vector<fs::path> paths;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error))
      paths.push_back(entry->path());
    if (error) skip(folder, error.message(), true);
    std::ranges::sort(paths, natural_less,
                      [](const fs::path& path) { return path.filename().string(); });
    for (const fs::path& path : paths) visit(path);
  }

  /// Returns true for a link to a place that is not below the folder.
  bool leads_out(const fs::path& path) const {
    std::error_code error;
    if (!fs::is_symlink(path, error)) return false;
    const fs::path relative = fs::canonical(path, error).lexically_relative(root);
    return !error && (relative.empty() || *relative.begin() == "..");
  }

  void visit(const fs::path& path) {
    std::error_code error;
    const std::string name = path.filename().string();
    if (name.starts_with('.')) return skip(path, "hidden");
    if (!is_plain_text(name))
      return skip(path, "its name contains control characters or is not UTF-8", true);
    if (leads_out(path))
      return skip(path, "link out of the folder; copy what it leads to, or import that itself",
                  true);
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) {
      if (!results.empty() && fs::equivalent(path, results, error))
        return skip(path, "the output folder");
      if (fs::exists(path / "journal.sqlite", error))
        return skip(path, "the output folder of a run");
      return enter(path);
    }
    if (fs::is_regular_file(status)) {
      found.files.push_back(path);
    } else {
      skip(path, fs::exists(status) ? "not a regular file" : "cannot be read: " + error.message());
    }
  }
};

}  // namespace

FolderFiles list_files(const fs::path& folder, const fs::path& results) {
  FolderWalk walk{results, {}, {}, {}};
  walk.enter(folder);
  if (!walk.found.left_out.empty() && walk.found.left_out.front().file == folder) {
    throw InputError(
        fmt::format("{}: cannot be read: {}", folder.string(), walk.found.left_out.front().reason));
  }
  return std::move(walk.found);
}

std::vector<std::string> folder_names(const fs::path& path) {
  std::vector<std::string> folders;
  for (const fs::path& part : path) {
    const std::string name = part.string();
    if (!name.empty() && name != "." && name != ".." && name != "/") folders.push_back(name);
  }
  return folders;
}

}  // namespace morphe::imports
