#include "core/files/atomic_file.hpp"
#include "core/store/demonstration_file.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/import.hpp"

namespace morphe::imports {

ImportResult write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                                  const std::function<void(const Demonstration&)>& seen) {
  for (const std::filesystem::path& path : request.paths) files::expect_not_input(out, path);
  store::DemonstrationWriter writer(out);
  ImportResult imported = import_recordings(request, [&](Demonstration&& demonstration) {
    writer.add(demonstration);
    if (seen) seen(demonstration);
  });
  for (const ManifestEntry& entry : imported.entries) {
    for (const std::string& file : {entry.file, entry.static_trial, entry.glove,
                                    entry.glove_static_trial, entry.glove_calibration, entry.names})
      files::expect_not_input(out, file);
  }
  writer.finish();
  return imported;
}

}  // namespace morphe::imports
