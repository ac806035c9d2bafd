#include "stages/import/folders/skipped_file.hpp"

#include <cctype>

namespace morphe::imports {

SkippedFile skipped_file_from_error(const std::filesystem::path& file, const InputError& error) {
  std::string why = error.what();
  const std::string name = file.string();
  if (why.starts_with(name)) why.erase(0, name.size());
  why.erase(0, why.find_first_not_of(": "));
  return {file, why, true};
}

std::string skip_message(const SkippedFile& one) {
  const bool line =
      !one.reason.empty() && std::isdigit(static_cast<unsigned char>(one.reason[0])) != 0;
  return one.file.string() + (one.failed && line ? ":" : ": ") +
         one.reason.substr(0, one.reason.find('\n'));
}

}  // namespace morphe::imports
