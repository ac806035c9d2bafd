#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stages/import/folders/import_request.hpp"

namespace morphe::commands {

/// Returns a hash of the program, of a request, and of size and times of the files on which its
/// import may depend. Throws InputError for unreadable manifests and folders.
std::string import_key(const imports::ImportRequest& request);

/// The results of an import, beside the demonstrations, for a run that continues a stopped one.
struct KeptImport {
  std::string key;       ///< import_key()
  int failed = 0;        ///< number of recordings that could not be read
  std::string text;      ///< what was printed
  std::string manifest;  ///< the lines of GeneratedManifest
};

/// Returns the import that was kept in a file with the given key; no value if there is none.
std::optional<KeptImport> read_kept_import(const std::filesystem::path& file,
                                           const std::string& key);
/// Writes the file. Throws InputError if it cannot be written.
void write_kept_import(const std::filesystem::path& file, const KeptImport& kept);

}  // namespace morphe::commands
