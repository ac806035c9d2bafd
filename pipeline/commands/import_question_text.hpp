#pragma once

#include <string>
#include <vector>

#include "stages/import/guess/unresolved_import.hpp"

namespace morphe::commands {

/// Returns instructions for a recording with unresolved properties: its content, the proposals with
/// their confidence, and the shell commands to paste, which are the given ones (`arguments`: those
/// of the program, without its name) with the options added; for a recording of a manifest, the
/// lines to be added to the manifest.
std::string import_question_text(const imports::UnresolvedImport& question,
                                 const std::vector<std::string>& arguments);

}  // namespace morphe::commands
