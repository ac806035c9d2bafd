#include "pipeline/run/output_files.hpp"

#include <fmt/format.h>

#include <map>
#include <system_error>

#include "core/motion/input_error.hpp"

namespace morphe::run {

namespace fs = std::filesystem;

OutputFiles::OutputFiles(const std::vector<fs::path>& files) {
  std::map<fs::path, fs::path> outputs;  // by lock file
  for (const fs::path& file : files) {
    std::error_code ignored;
    // A folder or device is refused by its writer (core/files/atomic_file.hpp).
    if (file.empty() || (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)))
      continue;
    const fs::path folder = fs::weakly_canonical(fs::absolute(file).parent_path(), ignored);
    if (!fs::is_directory(folder, ignored))
      throw InputError(
          fmt::format("{}: cannot be written: {} is not a folder", file.string(), folder.string()));
    const fs::path lock = folder / ("." + file.filename().string() + ".lock");
    if (!outputs.emplace(lock, file).second)
      throw InputError(fmt::format("{}: would be written twice; give another name", file.string()));
  }
  for (const auto& [lock, file] : outputs) locks_.emplace_back(lock, file, false);
}

}  // namespace morphe::run
