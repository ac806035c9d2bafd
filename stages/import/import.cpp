#include "stages/import/import.hpp"

#include "core/files/atomic_file.hpp"
#include "core/store/demonstration_file.hpp"
#include "stages/import/folders/find_recordings.hpp"
#include "stages/import/folders/read_recording.hpp"

namespace morphe::imports {

ImportResult import_recordings(const ImportRequest& request,
                               const std::function<void(Demonstration&&)>& sink) {
  FoundRecordings found = find_recordings(request);
  ImportResult imported;
  imported.skipped = std::move(found.left_out);
  for (ManifestEntry& entry : found.entries) {
    Demonstration demonstration;
    try {
      demonstration = read_recording(entry);
    } catch (const InputError& error) {
      if (!found.from_folder && !(request.keep_going && found.entries.size() > 1)) throw;
      imported.skipped.push_back(skipped_file_from_error(entry.file, error));
      continue;
    }
    sink(std::move(demonstration));
    imported.entries.push_back(std::move(entry));
  }
  require_recordings(request, imported);
  return imported;
}

ImportResult write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                                  const std::function<void(const Demonstration&)>& seen) {
  for (const std::filesystem::path& path : request.paths) files::expect_not_input(out, path);
  store::DemonstrationWriter writer(out);
  ImportResult imported = import_recordings(request, [&](Demonstration&& demonstration) {
    writer.add(demonstration);
    if (seen) seen(demonstration);
  });
  for (ManifestEntry& entry : imported.entries) {
    for (const std::string* file : paths_of(entry)) files::expect_not_input(out, *file);
  }
  writer.finish();
  return imported;
}

}  // namespace morphe::imports
