#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::config {

/// Fewest letters to insert, drop, change or swap with their neighbour that make `a` of `b`; case,
/// '-', '_' and ' ' make no difference.
std::size_t edits_between(std::string_view a, std::string_view b);

/// The candidate that differs by the fewest edits (the first of several), if these are no more than
/// a third of the letters; "" if there is none.
std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean 'x'?", or "".
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

/// The same for a file that is not there, with what lies in its folder.
std::string did_you_mean_file(const std::filesystem::path& missing);

}  // namespace morphe::config
