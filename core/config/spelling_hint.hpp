#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::config {

/// Returns the smallest number of insertions, deletions, substitutions and swaps of adjacent
/// letters that transform `b` into `a`; case and the characters '-', '_' and ' ' are ignored.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the candidate with the smallest edit distance (the first of several), if it is at most a
/// third of the letters; otherwise "".
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// Returns "; did you mean 'x'?", or "".
std::string spelling_hint(std::string_view word, const std::vector<std::string>& candidates);

/// Returns the same hint for a missing file, with the names in its folder as candidates.
std::string file_spelling_hint(const std::filesystem::path& missing);

}  // namespace morphe::config
