#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace morphe::fuzz {

/// The number-th file that is made of seeds for a target: one of them with one to sixteen changes
/// (a bit, a byte, a number or a word, a part that is left out, doubled, moved, or another seed's),
/// at most 64 KB. The same on every machine. There must be a seed.
std::string mutant(const std::vector<std::string>& seeds, const std::vector<std::string>& words,
                   const std::string& target, std::uint64_t number);

/// Of a dictionary of libFuzzer: "word" and "\x00" a line, # a comment.
std::vector<std::string> words_of(const std::string& dictionary);

}  // namespace morphe::fuzz
