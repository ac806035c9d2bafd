#include "core/files/data_files.hpp"

#include <dlfcn.h>
#include <link.h>

namespace morphe::files {
namespace {

namespace fs = std::filesystem;

/// Returns the path of the program or shared library that contains this function.
fs::path this_module() {
  Dl_info info{};
  link_map* map = nullptr;
  if (dladdr1(reinterpret_cast<const void*>(&this_module), &info, reinterpret_cast<void**>(&map),
              RTLD_DL_LINKMAP) == 0)
    return {};
  // The program itself has an empty name in the list of loaded modules.
  std::error_code ignored;
  return fs::canonical(*map->l_name ? map->l_name : "/proc/self/exe", ignored);
}

/// Returns the folder of shipped files: PREFIX/bin/morphe and PREFIX/lib/libmorphe.so, or
/// lib/x86_64-linux-gnu, -> PREFIX/share/morphe; SOURCES/build/release/morphe -> SOURCES.
fs::path data_folder() {
  const fs::path above = this_module().parent_path().parent_path(), top = above.parent_path();
  for (const fs::path& folder : {above / "share/morphe", top / "share/morphe", top})
    if (fs::is_directory(folder / "configs/pipelines")) return folder;
  return {};
}

}  // namespace

fs::path resolve_data_file(const fs::path& named, const fs::path& shipped) {
  if (shipped.empty() || named.empty() || named.is_absolute() || fs::exists(named)) return named;
  const fs::path folder = named.parent_path();
  const bool only_there = !folder.empty() && !fs::exists(folder) && fs::exists(shipped / folder);
  return only_there || fs::exists(shipped / named) ? shipped / named : named;
}

fs::path resolve_data_file(const fs::path& named) {
  return resolve_data_file(named, data_folder());
}

}  // namespace morphe::files
