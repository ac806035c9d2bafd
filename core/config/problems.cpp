#include "core/config/problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace morphe::config {

void Problems::add(const std::string& line) {
  if (std::ranges::find(lines_, line) == lines_.end()) lines_.push_back(line);
}

void Problems::add(const Problems& more) {
  for (const std::string& line : more.lines_) add(line);
}

void Problems::throw_any() const {
  constexpr std::size_t kMost = 20;
  if (lines_.empty()) return;
  const std::size_t told = std::min(kMost, lines_.size());
  std::string text = fmt::format("{}", fmt::join(lines_.begin(), lines_.begin() + told, "\n"));
  if (lines_.size() > told) text += fmt::format("\n… and {} more", lines_.size() - told);
  throw InputError(text);
}

}  // namespace morphe::config
