#include "pipeline/planning/unpacked_inputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "core/motion/input_error.hpp"

namespace morphe::planning {

namespace fs = std::filesystem;

UnpackedInputs::UnpackedInputs(const std::vector<PlanFileHeader::Input>& inputs) {
  std::string name = (fs::temp_directory_path() / "morphe_from_XXXXXX").string();
  if (!::mkdtemp(name.data())) throw InputError(fmt::format("{}: cannot be created", name));
  folder_ = name;
  try {
    for (const PlanFileHeader::Input& input : inputs) {
      const fs::path file = (folder_ / input.path).lexically_normal();
      if (!contains(file))
        throw InputError(fmt::format("/inputs/{}: is outside of /inputs", input.path));
      fs::create_directories(file.parent_path());
      std::ofstream(file, std::ios::binary) << input.text;
      folders_.push_back(file.parent_path());
      files_.push_back(file);
    }
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    throw;
  }
}

UnpackedInputs::~UnpackedInputs() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

bool UnpackedInputs::contains(const fs::path& file) const {
  return !file.lexically_normal().lexically_relative(folder_).string().starts_with("..");
}

fs::path UnpackedInputs::find(const fs::path& named) const {
  for (const fs::path& wanted : {named, named.filename()}) {
    for (const fs::path& folder : folders_) {
      const fs::path file = folder / wanted;
      if (wanted.is_relative() && contains(file) && fs::is_regular_file(file)) return file;
    }
  }
  return {};
}

std::vector<fs::path> UnpackedInputs::find_all(const fs::path& named) const {
  std::vector<fs::path> found;
  if (const fs::path first = find(named); !first.empty()) found.push_back(first);
  for (const fs::path& file : files_) {
    const bool is_first = !found.empty() && file == found.front();
    if (file.filename() != named.filename() || is_first) continue;
    found.push_back(file);
    std::error_code ignored;
    for (const fs::path& other : files_)
      fs::copy_file(other, file.parent_path() / other.filename(), fs::copy_options::skip_existing,
                    ignored);
  }
  return found;
}

std::string UnpackedInputs::with_stored_paths(std::string message) const {
  const std::string folder = folder_.string();
  for (std::size_t begin; (begin = message.find(folder)) != std::string::npos;)
    message.replace(begin, folder.size(), "/inputs");
  return message;
}

}  // namespace morphe::planning
