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
  try {
    lock_.emplace(path_ / ".lock", path_, true);  // creates the folder, too
  } catch (const InputError&) {
    remove_made();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  lock_.reset();
  if (!kept_) remove_made();
}

void OutputFolder::remove_made() const {
  std::error_code ignored;
  for (const fs::path& folder : made_) fs::remove(folder, ignored);
}

}  // namespace morphe::run
