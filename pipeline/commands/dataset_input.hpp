#pragma once

#include <filesystem>
#include <string>

#include "stages/import/import.hpp"

namespace morphe::commands {

/// A demonstrations.h5, by its ending or its first bytes; anything else is to be imported.
bool is_demonstrations(const std::filesystem::path& file);

/// For people: what was found in the folders of a request, what was assumed of it, a line for each
/// file that was left out (many with one reason: the first of them and their number). "" if there
/// is nothing to tell.
std::string found_text(const imports::Imported& imported);

/// How many recordings could not be read.
int failed_in(const imports::Imported& imported);

/// The manifest of what was found, beside a result. One that was written by somebody else, or
/// edited since, is not replaced: InputError, from check() before anything is done.
class FoundManifest {
 public:
  explicit FoundManifest(std::filesystem::path file) : file_(std::move(file)) {}
  void check() const;
  void write(const imports::Imported& imported) const;

 private:
  std::filesystem::path file_;
};

}  // namespace morphe::commands
