#pragma once

#include <string>
#include <vector>

#include "stages/import/folders/skipped_file.hpp"
#include "stages/import/guess/unresolved_import.hpp"

namespace morphe::commands {

/// Returns instructions for a recording with unresolved properties: its content, the proposals with
/// their confidence, and the command line to paste, which is `arguments` (those of the program,
/// without its name) with the proposals as options, or the lines to add to its manifest.
std::string import_question_text(const imports::UnresolvedImport& question,
                                 const std::vector<std::string>& arguments);

/// Returns a line for each recording that was skipped with a question: the command that imports it
/// with the proposals, or the lines for its manifest. Recordings that need the same line share one.
/// Returns "" if there is no such recording.
std::string skipped_questions_text(const std::vector<imports::SkippedFile>& skipped);

}  // namespace morphe::commands
