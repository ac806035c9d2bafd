#include "stages/import/folders/skipped_file.hpp"

#include <utility>

namespace morphe::imports {

SkippedFile skipped_file_from_error(const std::filesystem::path& file, const InputError& error) {
  std::string reason = error.what();
  if (reason.starts_with(file.string())) reason.erase(0, file.string().size());
  reason.erase(0, reason.find_first_not_of(": "));
  SkippedFile skipped{file, reason, true};
  if (const auto* const question = dynamic_cast<const UnresolvedImport*>(&error)) {
    auto kept = std::make_shared<UnresolvedImport>(*question);
    kept->demonstration.reset();
    skipped.question = std::move(kept);
  }
  return skipped;
}

std::string skip_message(const SkippedFile& file) {
  const std::string& reason = file.reason;
  const bool has_line = file.failed && !reason.empty() && reason[0] >= '0' && reason[0] <= '9';
  return file.file.string() + (has_line ? ":" : ": ") + reason.substr(0, reason.find('\n'));
}

}  // namespace morphe::imports
