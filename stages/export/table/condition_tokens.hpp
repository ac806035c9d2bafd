#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::exports {

/// A part of a condition.
struct Token {
  enum class Kind { number, word, quoted, comparison, open, close, end };
  Kind kind = Kind::end;
  std::string text;       ///< without the quotes
  double number = 0;      ///< of a number
  std::size_t begin = 0;  ///< index of its first character

  bool is_word(std::string_view word) const { return kind == Kind::word && text == word; }
};

/// Throws InputError "--where 'TEXT', at character N: MESSAGE"; `at` counts from 0.
[[noreturn]] void fail_condition(const std::string& text, std::size_t at,
                                 const std::string& message);

/// Returns the parts of a condition; the last one is the end. Throws like fail_condition().
std::vector<Token> condition_tokens(const std::string& text);

}  // namespace morphe::exports
