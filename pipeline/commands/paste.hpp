#pragma once

#include <string>
#include <vector>

#include "stages/import/guess/import_question.hpp"

namespace morphe::commands {

/// What to do about a recording that leaves something open: what it holds, what is proposed with
/// how sure it is, and the shell commands to paste: the given ones (`arguments`: those of the
/// program, without its name) with the options added; for a recording of a manifest the lines to
/// add there.
std::string question_text(const imports::ImportQuestion& question,
                          const std::vector<std::string>& arguments);

}  // namespace morphe::commands
