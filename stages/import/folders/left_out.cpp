#include "stages/import/folders/left_out.hpp"

#include <cctype>

namespace morphe::imports {

LeftOut unreadable(const std::filesystem::path& file, const InputError& error) {
  std::string why = error.what();
  const std::string name = file.string();
  if (why.starts_with(name)) why.erase(0, name.size());
  why.erase(0, why.find_first_not_of(": "));
  return {file, why, true};
}

std::string sentence_of(const LeftOut& one) {
  const bool line = !one.why.empty() && std::isdigit(static_cast<unsigned char>(one.why[0])) != 0;
  return one.file.string() + (one.failed && line ? ":" : ": ") +
         one.why.substr(0, one.why.find('\n'));
}

}  // namespace morphe::imports
