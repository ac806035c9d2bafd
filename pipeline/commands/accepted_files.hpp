#pragma once

#include <string>

namespace morphe::commands {

/// Returns true if this program has accepted a file with this SHA-256 for the user. The notes are
/// empty files in $XDG_CACHE_HOME/morphe/accepted (~/.cache/morphe/accepted), named by the SHA-256
/// of file and program; a folder that another user may write is not believed.
bool is_known_accepted(const std::string& file_sha256);

/// Notes that; does nothing if it cannot be noted.
void note_accepted(const std::string& file_sha256);

}  // namespace morphe::commands
