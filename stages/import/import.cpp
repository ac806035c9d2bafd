#include "stages/import/import.hpp"

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
      if (!found.from_folder) throw;
      imported.skipped.push_back(skipped_file_from_error(entry.file, error));
      continue;
    }
    sink(std::move(demonstration));
    imported.entries.push_back(std::move(entry));
  }
  require_recordings(request, imported);
  return imported;
}

}  // namespace morphe::imports
