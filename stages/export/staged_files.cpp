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

CreatedFolders::~CreatedFolders() {
  std::error_code ignored;
  for (auto folder = created_.rbegin(); folder != created_.rend(); ++folder)
    std::filesystem::remove(*folder, ignored);
}

void CreatedFolders::create(const std::filesystem::path& folder) {
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return;
  create(folder.parent_path());
  if (std::filesystem::create_directory(folder, error)) created_.push_back(folder);
  if (error)
    throw InputError(fmt::format("{}: cannot be created: {}", folder.string(), error.message()));
}

void StagedFiles::expect_no_others(const std::string& inner, const std::string& ending) const {
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(folder_ / inner, ignored)) {
    const std::string name = entry.path().lexically_relative(folder_).generic_string();
    if (name.ends_with(ending) && !used_names_.contains(name))
      throw InputError(fmt::format(
          "{}: is of another dataset and would be read as part of this one: remove it, or give "
          "another --out",
          entry.path().string()));
  }
}

files::AtomicFile& StagedFiles::add(const std::string& name) {
  if (!used_names_.insert(name).second) {
    throw InputError(
        fmt::format("{}: two plans would be written to it", (folder_ / name).string()));
  }
  created_.create((folder_ / name).parent_path());
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
