#include "stages/import/import.hpp"

#include "stages/import/folders/find_recordings.hpp"
#include "stages/import/folders/read_recording.hpp"

namespace morphe::imports {

Imported import_recordings(const ImportRequest& request,
                           const std::function<void(Demonstration&&)>& sink) {
  FoundRecordings found = find_recordings(request);
  Imported imported;
  imported.left_out = std::move(found.left_out);
  for (ManifestEntry& entry : found.entries) {
    Demonstration demonstration;
    try {
      demonstration = read_recording(entry);
    } catch (const InputError& error) {
      if (!found.of_folder) throw;
      imported.left_out.push_back(unreadable(entry.file, error));
      continue;
    }
    sink(std::move(demonstration));
    imported.entries.push_back(std::move(entry));
  }
  expect_some(request, imported);
  return imported;
}

}  // namespace morphe::imports
