#include "stages/export/staged_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "core/motion/input_error.hpp"

namespace morphe::exports {
namespace {

bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return first && second && std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

}  // namespace

files::AtomicFile& StagedFiles::add(const std::string& name) {
  if (!used_names_.insert(name).second) {
    throw InputError(
        fmt::format("{}: two plans would be written to it", (folder_ / name).string()));
  }
  names_.push_back(name);
  return files_.emplace_back(folder_ / name);
}

void StagedFiles::commit(bool replace) {
  for (const files::AtomicFile& file : files_) {
    if (replace || !std::filesystem::exists(file.target())) continue;
    if (same_bytes(file.part(), file.target())) continue;
    throw InputError(
        fmt::format("{}: already exists with other content: give another --out, or --replace",
                    file.target().string()));
  }
  std::vector<std::filesystem::path> created;
  try {
    for (files::AtomicFile& file : files_) {
      if (!std::filesystem::exists(file.target())) created.push_back(file.target());
      file.commit();
    }
  } catch (const InputError&) {
    std::error_code ignored;
    for (const std::filesystem::path& file : created) std::filesystem::remove(file, ignored);
    throw;
  }
}

}  // namespace morphe::exports
