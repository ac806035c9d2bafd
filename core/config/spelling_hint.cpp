#include "core/config/spelling_hint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>
#include <utility>

#include "core/config/renamed_keys.hpp"
#include "core/files/data_files.hpp"

namespace morphe::config {
namespace {

namespace fs = std::filesystem;

char plain_letter(char c) {
  if (c == '-' || c == ' ') return '_';
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// Returns the shipped config or dataset whose name is the word, with or without extension; "" if
/// there is none.
fs::path shipped_file_named(const std::string& word) {
  for (const char* const folder : {"configs/pipelines", "configs/robots", "configs/studies",
                                   "configs/synthetic", "datasets"}) {
    std::error_code ignored;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(files::resolve_data_file(folder), ignored)) {
      const fs::path& path = entry.path();
      const bool config = path.extension() == ".yaml" || entry.is_directory(ignored);
      if (config && (path.stem() == word || path.filename() == word))
        return fs::path(folder) / path.filename();
    }
  }
  return {};
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const char x = plain_letter(a[i - 1]), y = plain_letter(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (x == y ? 0U : 1U)});
      if (i > 1 && j > 1 && x == plain_letter(b[j - 2]) && y == plain_letter(a[i - 2]))
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  std::string nearest;
  std::size_t min_edits = 0;
  for (const std::string& candidate : candidates) {
    const std::size_t edits = edit_distance(word, candidate);
    const std::size_t letters = std::max(word.size(), candidate.size());
    if (3 * edits > std::max<std::size_t>(letters, 3) || edits == letters ||
        (!nearest.empty() && edits >= min_edits))
      continue;
    nearest = candidate;
    min_edits = edits;
  }
  return nearest;
}

std::string spelling_hint(std::string_view word, const std::vector<std::string>& candidates) {
  std::string renamed = renaming_hint(word, candidates);
  if (!renamed.empty()) return renamed;
  const std::string meant = nearest_word(word, candidates);
  return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

std::string file_spelling_hint(const fs::path& missing) {
  std::error_code ignored;
  const fs::path folder = missing.parent_path();
  if (fs::exists(missing, ignored)) return "";
  std::vector<std::string> names;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(folder.empty() ? "." : folder, ignored))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  const auto stem = std::ranges::find_if(
      names, [&](const std::string& name) { return fs::path(name).stem() == missing.filename(); });
  const std::string meant =
      stem != names.end() ? *stem : nearest_word(missing.filename().string(), names);
  if (!meant.empty()) return fmt::format("; did you mean '{}'?", (folder / meant).string());
  const fs::path shipped = folder.empty() ? shipped_file_named(missing.string()) : fs::path();
  return shipped.empty() ? "" : fmt::format("; did you mean '{}'?", shipped.string());
}

}  // namespace morphe::config
