#include "stages/export/table/condition_tokens.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

#include "core/files/printable.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::exports {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns true for the characters of names, codes, units and file names; all beyond ASCII count.
bool is_word_character(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || is_digit(c) || static_cast<unsigned char>(c) >= 0x80 ||
         std::string_view("_-./:%^+").find(c) != std::string_view::npos;
}

class Tokenizer {
 public:
  explicit Tokenizer(const std::string& text) : text_(text) {}

  std::vector<Token> run() {
    std::vector<Token> tokens;
    do {
      while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
      tokens.push_back(next());
    } while (tokens.back().kind != Token::Kind::end);
    return tokens;
  }

 private:
  Token next() {
    if (at_ == text_.size()) return {Token::Kind::end, "", 0, at_};
    const char c = text_[at_];
    if (c == '(' || c == ')') return take(c == '(' ? Token::Kind::open : Token::Kind::close, 1);
    constexpr std::array<std::string_view, 7> kComparisons{"<=", ">=", "!=", "==", "<", ">", "="};
    for (const std::string_view comparison : kComparisons)
      if (std::string_view(text_).substr(at_).starts_with(comparison))
        return take(Token::Kind::comparison, comparison.size());
    if (c == '\'' || c == '"') return quoted();
    if (begins_number()) return number();
    std::size_t end = at_;
    while (end < text_.size() && is_word_character(text_[end])) ++end;
    if (end == at_)
      fail_condition(text_, at_,
                     fmt::format("'{}' was not expected", files::make_printable({&c, 1})));
    return take(Token::Kind::word, end - at_);
  }

  /// Returns true at a digit, or before one at a sign or a point.
  bool begins_number() const {
    std::size_t at = at_;
    if (text_[at] == '-' || text_[at] == '+') ++at;
    if (at < text_.size() && text_[at] == '.') ++at;
    return at < text_.size() && is_digit(text_[at]);
  }

  /// Takes a number, or a word that begins with a digit, such as a name.
  Token number() {
    const char* begin = text_.data() + at_ + (text_[at_] == '+' ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value))
      fail_condition(text_, at_, "is not a finite number");
    Token token = take(Token::Kind::number, end - (text_.data() + at_));
    token.number = value;
    return token;
  }

  Token quoted() {
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == std::string::npos) fail_condition(text_, at_, "the quote is not closed");
    Token token = take(Token::Kind::quoted, end + 1 - at_);
    token.text = token.text.substr(1, token.text.size() - 2);
    return token;
  }

  Token take(Token::Kind kind, std::size_t size) {
    const Token token{kind, text_.substr(at_, size), 0, at_};
    at_ += size;
    return token;
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

}  // namespace

void fail_condition(const std::string& text, std::size_t at, const std::string& message) {
  throw InputError(fmt::format("--where '{}', at character {}: {}", files::make_printable(text),
                               at + 1, message));
}

std::vector<Token> condition_tokens(const std::string& text) { return Tokenizer(text).run(); }

}  // namespace morphe::exports
