#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::config {

/// Returns the smallest number of insertions, deletions, substitutions and swaps of adjacent
/// letters that transform `b` into `a`; case is ignored, and '-', '_' and ' ' are the same letter.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Returns the first candidate of least edit distance, "" if that is over a third of the letters.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// Returns renaming_hint(), or if that is empty "; did you mean 'x'?" with nearest_word(), or "".
std::string spelling_hint(std::string_view word, const std::vector<std::string>& candidates);

/// Returns "; did you mean 'x'?" with the name in the folder of a missing file that has the same
/// stem or is nearest, or for a bare word with the shipped config or dataset of that name; else "".
std::string file_spelling_hint(const std::filesystem::path& missing);

}  // namespace morphe::config
