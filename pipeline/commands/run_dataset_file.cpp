#include "pipeline/commands/run_dataset_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/motion/input_error.hpp"
#include "pipeline/commands/assumptions.hpp"
#include "pipeline/commands/shared_options.hpp"

namespace morphe::commands {
namespace {

namespace fs = std::filesystem;

bool are_all_manifests(const std::vector<fs::path>& named) {
  return std::ranges::all_of(named, [](const fs::path& path) {
    return !fs::is_directory(path) && (path.extension() == ".yaml" || path.extension() == ".yml");
  });
}

}  // namespace

RunDatasetFile::RunDatasetFile(imports::ImportRequest request, const fs::path& folder, bool fresh)
    : file_(request.paths.front()), manifest_(folder / "recordings.yaml") {
  for (const fs::path& named : request.paths) {
    key_ += fs::weakly_canonical(named).string() + "\n";
    if (fs::is_directory(named) || !is_demonstrations_file(named)) continue;
    if (request.paths.size() > 1)
      throw InputError(fmt::format("{}: an HDF5 dataset cannot be combined with other datasets",
                                   named.string()));
    expect_no_import_options(request, named);
    return;
  }
  writes_manifest_ = !are_all_manifests(request.paths);
  if (writes_manifest_) manifest_.expect_replaceable();
  final_file_ = folder / "demonstrations.h5";
  file_ = folder / "demonstrations.h5.new";
  record_ = folder / "demonstrations.h5.new.json";
  request.results_folder = folder;
  import(request, fresh);
}

void RunDatasetFile::import(const imports::ImportRequest& request, bool fresh) {
  const std::string key = import_key(request);
  std::error_code error;
  const std::optional<KeptImport> kept =
      fresh || !fs::exists(file_, error) ? std::nullopt : read_kept_import(record_, key);
  if (kept) {
    import_ = *kept;
    fmt::print(stderr, "{}the recordings are unchanged and not imported again\n", import_.text);
    return;
  }
  fs::remove(record_, error);
  Assumptions assumptions;
  const imports::ImportResult imported = imports::write_demonstrations(
      request, file_, [&](const Demonstration& demonstration) { assumptions.add(demonstration); });
  import_ = {key, count_failed(imported), import_summary_text(imported) + assumptions.text(),
             manifest_.lines(imported)};
  fmt::print(stderr, "{}", import_.text);
  write_kept_import(record_, import_);
}

RunDatasetFile::~RunDatasetFile() {
  std::error_code ignored;
  if (final_file_.empty() || kept_) return;
  fs::remove(file_, ignored);
  fs::remove(record_, ignored);
}

void RunDatasetFile::publish() {
  if (final_file_.empty()) return;
  std::error_code ignored;
  fs::remove(record_, ignored);
  fs::rename(file_, final_file_);
  file_ = std::exchange(final_file_, {});
  if (writes_manifest_) manifest_.write(import_.manifest);
}

}  // namespace morphe::commands
