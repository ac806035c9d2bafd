#include "core/config/error_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace morphe::config {

void ErrorList::add(const std::string& line) {
  if (std::ranges::find(lines_, line) == lines_.end()) lines_.push_back(line);
}

void ErrorList::add(const ErrorList& more) {
  for (const std::string& line : more.lines_) add(line);
}

void ErrorList::throw_if_any() const {
  constexpr std::size_t kMaxReportedLines = 20;
  if (lines_.empty()) return;
  const std::size_t reported = std::min(kMaxReportedLines, lines_.size());
  std::string text = fmt::format("{}", fmt::join(lines_.begin(), lines_.begin() + reported, "\n"));
  if (lines_.size() > reported) text += fmt::format("\n… and {} more", lines_.size() - reported);
  throw InputError(text);
}

}  // namespace morphe::config
