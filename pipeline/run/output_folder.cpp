#include "pipeline/run/output_folder.hpp"

#include <fmt/format.h>

#include "core/motion/input_error.hpp"

namespace morphe::run {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) throw InputError("--out: is not a folder name");
  std::error_code error;
  for (fs::path folder = fs::absolute(path_).lexically_normal(); !fs::exists(folder, error);
       folder = folder.parent_path())
    made_.push_back(folder);
  fs::create_directories(path_, error);
  if (error || !fs::is_directory(path_)) {
    remove_made();
    throw InputError(fmt::format("{}: the folder cannot be created", path_.string()));
  }
}

OutputFolder::~OutputFolder() {
  if (!kept_) remove_made();
}

void OutputFolder::remove_made() const {
  std::error_code ignored;
  for (const fs::path& folder : made_) fs::remove(folder, ignored);
}

}  // namespace morphe::run
