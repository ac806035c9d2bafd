#include "stages/export/table/condition.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "core/config/spelling_hint.hpp"
#include "core/files/printable.hpp"
#include "stages/export/table/condition_tokens.hpp"

namespace morphe::exports {
namespace {

using TokenKind = Token::Kind;

/// A unit in which a number may be given.
struct InputUnit {
  std::string_view name, si;
  double per_si;  ///< how many of it are one SI unit
};
constexpr std::array<InputUnit, 13> kUnits{{{"m", "m", 1},
                                            {"cm", "m", 1e2},
                                            {"mm", "m", 1e3},
                                            {"um", "m", 1e6},
                                            {"rad", "rad", 1},
                                            {"deg", "rad", 180 / std::numbers::pi},
                                            {"s", "s", 1},
                                            {"ms", "s", 1e3},
                                            {"m^2", "m^2", 1},
                                            {"cm^2", "m^2", 1e4},
                                            {"mm^2", "m^2", 1e6},
                                            {"N", "N", 1},
                                            {"%", "1", 100}}};

std::string units_of(std::string_view si) {
  std::vector<std::string_view> names;
  for (const InputUnit& unit : kUnits)
    if (unit.si == si) names.push_back(unit.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

bool is_number(const PlanColumn& column) {
  return column.type == parquet::ValueType::float64 || column.type == parquet::ValueType::int64;
}

/// Returns whether "value COMPARISON other" holds for two values of one type.
template <class Value>
bool compare(const Value& value, std::string_view comparison, const Value& other) {
  if (comparison == "<") return value < other;
  if (comparison == "<=") return value <= other;
  if (comparison == ">") return value > other;
  if (comparison == ">=") return value >= other;
  return comparison == "!=" ? value != other : value == other;
}

}  // namespace

struct Condition::Node {
  enum class Kind { all, any, negation, comparison };
  Kind kind = Kind::comparison;
  std::vector<Node> parts;
  const PlanColumn* column = nullptr;  ///< of a comparison
  std::string comparison;
  Cell value;  ///< a double for all columns with numbers

  /// Returns the truth, or nothing if it is unknown.
  std::optional<bool> truth(const PlanEntry& entry) const;
};

namespace {

using Node = Condition::Node;

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text), tokens_(condition_tokens(text)) {}

  Node run() {
    Node root = any(0);
    if (now().kind != TokenKind::end) fail("'and', 'or' or the end was expected");
    return root;
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  Token take() { return tokens_[at_++]; }
  [[noreturn]] void fail(const std::string& message) const { fail(now(), message); }
  [[noreturn]] void fail(const Token& token, const std::string& message) const {
    fail_condition(text_, token.begin, message);
  }

  Node any(int depth) {
    return sequence(Node::Kind::any, "or", [&] {
      return sequence(Node::Kind::all, "and", [&] { return negation(depth); });
    });
  }

  template <class Part>
  Node sequence(Node::Kind kind, std::string_view word, const Part& part) {
    Node first = part();
    if (!now().is_word(word)) return first;
    Node node;
    node.kind = kind;
    node.parts.push_back(std::move(first));
    while (now().is_word(word)) {
      take();
      node.parts.push_back(part());
    }
    return node;
  }

  Node negation(int depth) {
    constexpr int kMaxDepth = 100;
    if (depth > kMaxDepth) fail("is nested too deeply");
    if (now().is_word("not")) {
      take();
      Node node;
      node.kind = Node::Kind::negation;
      node.parts.push_back(negation(depth + 1));
      return node;
    }
    if (now().kind != TokenKind::open) return comparison();
    const Token open = take();
    Node inner = any(depth + 1);
    if (now().kind != TokenKind::close) fail(open, "the parenthesis is not closed");
    take();
    return inner;
  }

  Node comparison() {
    if (now().kind != TokenKind::word) fail("the name of a column was expected");
    Node node;
    node.column = &column(take());
    if (now().kind != TokenKind::comparison && node.column->type == parquet::ValueType::boolean) {
      node.comparison = "=";
      node.value = true;
      return node;
    }
    if (now().kind != TokenKind::comparison)
      fail(fmt::format("one of < <= > >= = != was expected after {}", node.column->name));
    const Token sign = take();
    node.comparison = sign.text == "==" ? "=" : sign.text;
    if (!is_number(*node.column) && node.comparison != "=" && node.comparison != "!=")
      fail(sign, fmt::format("{} is not a number: compare it with = or !=", node.column->name));
    node.value = value(*node.column);
    return node;
  }

  const PlanColumn& column(const Token& token) const {
    const auto found = std::ranges::find(plan_columns(), token.text, &PlanColumn::name);
    if (found != plan_columns().end()) return *found;
    std::vector<std::string> names;
    for (const PlanColumn& each : plan_columns()) names.emplace_back(each.name);
    std::string hint = config::spelling_hint(token.text, names);
    if (hint.empty()) hint = fmt::format("; the columns are {}", fmt::join(names, ", "));
    fail(token, fmt::format("'{}' is not a column{}", files::make_printable(token.text), hint));
  }

  Cell value(const PlanColumn& column) {
    if (is_number(column)) return number(column);
    if (now().kind == TokenKind::end || now().kind == TokenKind::open ||
        now().kind == TokenKind::close || now().kind == TokenKind::comparison)
      fail(fmt::format("a value of {} was expected", column.name));
    const Token token = take();
    if (column.type == parquet::ValueType::boolean) {
      if (token.text != "true" && token.text != "false")
        fail(token, fmt::format("{} is true or false", column.name));
      return token.text == "true";
    }
    if (column.words) {
      const std::vector<std::string> words = column.words();
      if (std::ranges::find(words, token.text) == words.end())
        fail(token, fmt::format("{} is never '{}'{}", column.name,
                                files::make_printable(token.text), hint(token.text, words)));
    }
    return token.text;
  }

  static std::string hint(const std::string& word, const std::vector<std::string>& words) {
    const std::string spelling = config::spelling_hint(word, words);
    return spelling.empty() ? fmt::format(", but {}", fmt::join(words, ", ")) : spelling;
  }

  Cell number(const PlanColumn& column) {
    if (now().kind != TokenKind::number)
      fail(fmt::format("a number was expected: {} is one", column.name));
    const Token token = take();
    const bool has_unit =
        now().kind == TokenKind::word && !now().is_word("and") && !now().is_word("or");
    if (!has_unit) {
      if (column.unit != "1")
        fail(token, fmt::format("{} has a unit: write {} {}", column.name, token.text,
                                units_of(column.unit)));
      return token.number;
    }
    const Token unit = take();
    for (const InputUnit& each : kUnits)
      if (each.name == unit.text && each.si == column.unit) return token.number / each.per_si;
    fail(unit, fmt::format("'{}' is not a unit of {}: {}", files::make_printable(unit.text),
                           column.name, units_of(column.unit)));
  }

  const std::string& text_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
};

}  // namespace

std::optional<bool> Condition::Node::truth(const PlanEntry& entry) const {
  if (kind == Kind::comparison) {
    const Cell cell = column->value(entry);
    if (const auto* integer = std::get_if<std::int64_t>(&cell))
      return compare(static_cast<double>(*integer), comparison, std::get<double>(value));
    if (const auto* number = std::get_if<double>(&cell))
      return compare(*number, comparison, std::get<double>(value));
    if (std::holds_alternative<std::monostate>(cell)) return std::nullopt;
    return compare(cell, comparison, value);
  }
  if (kind == Kind::negation) {
    const std::optional<bool> inner = parts.front().truth(entry);
    return inner ? std::optional(!*inner) : std::nullopt;
  }
  // One false part decides `and`, one true part `or`.
  const bool decisive = kind == Kind::any;
  std::optional<bool> result = !decisive;
  for (const Node& part : parts) {
    const std::optional<bool> truth = part.truth(entry);
    if (truth == decisive) return decisive;
    if (!truth) result.reset();
  }
  return result;
}

Condition::Condition(const std::string& text) : root_(new Node(Parser(text).run())) {}
Condition::~Condition() = default;
Condition::Condition(Condition&&) noexcept = default;

bool Condition::holds(const PlanEntry& entry) const { return root_->truth(entry) == true; }

}  // namespace morphe::exports
