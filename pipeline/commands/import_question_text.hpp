#pragma once

#include <string>
#include <vector>

#include "stages/import/guess/unresolved_import.hpp"

namespace morphe::commands {

/// Returns instructions for a recording with unresolved properties: its content, the proposals with
/// their confidence, and the command line to paste, which is `arguments` (those of the program,
/// without its name) with the proposals as options, or the lines to add to its manifest.
std::string import_question_text(const imports::UnresolvedImport& question,
                                 const std::vector<std::string>& arguments);

}  // namespace morphe::commands
