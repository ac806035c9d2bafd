#pragma once

#include <fmt/format.h>

#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/node.hpp"
#include "core/config/renamed_keys.hpp"
#include "core/motion/enum_names.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::config {

/// Options structs are described once, for reading and writing:
///
///     struct SegmentOptions { double onset_share = 0.05; };
///     template <class Fields>
///     void fields(Fields& f, SegmentOptions& o) {
///       f("onset_share", o.onset_share, bounds::kShare);  // numbers need bounds
///     }
///     std::string validation_error(const SegmentOptions& o);   // optional: "" or the error
///
/// read_options(node, options) keeps the default if a key is absent, and throws one InputError with
/// all errors, a line each; write_options returns YAML from which read_options restores the same
/// values. Supported types: bool, int, std::uint64_t, double, std::string, Vec3, named
/// enumerations, vectors and optionals of these, and structs that have fields(). Numbers are
/// declared with the bounds of their values, of each component and item; seeds have no bounds.
class FieldReader;
class FieldWriter;

/// A struct that has fields().
template <class T>
concept HasFields = requires(FieldWriter& f, T& options) {
  fields(f, options);
};
/// A number, or several of them, whose key is declared with bounds.
template <class T>
inline constexpr bool kNeedsBounds =
    std::same_as<T, int> || std::same_as<T, double> || std::same_as<T, Vec3>;
template <class T>
inline constexpr bool kNeedsBounds<std::vector<T>> = kNeedsBounds<T>;
template <class T>
inline constexpr bool kNeedsBounds<std::optional<T>> = kNeedsBounds<T>;
/// A type whose keys are declared without bounds, and one whose keys need them.
template <class T>
concept Unbounded = !kNeedsBounds<T>;
template <class T>
concept Bounded = kNeedsBounds<T>;

/// A struct that has validation_error().
template <class T>
concept HasValidationError = requires(const T& options) {
  { validation_error(options) } -> std::same_as<std::string>;
};

/// Reads the fields of a struct; adds errors to `problems` and goes on with the next key.
class FieldReader {
 public:
  /// Makes a reader of a section.
  FieldReader(ConfigNode node, ErrorList& problems) : node_(std::move(node)), problems_(problems) {}

  /// Reads a key, or keeps the default if it is absent.
  template <Unbounded T>
  void operator()(const char* key, T& value) {
    if (node_.has(key)) required(key, value);
  }
  template <Bounded T>
  void operator()(const char* key, T& value, const KeyBounds& bounds) {
    if (node_.has(key)) required(key, value, bounds);
  }
  /// Reads a key that has no default.
  template <Unbounded T>
  void required(const char* key, T& value) {
    problems_.attempt([&] { read(node_[key], value); });
  }
  template <Bounded T>
  void required(const char* key, T& value, const KeyBounds& bounds) {
    problems_.attempt([&] { read(node_[key], value, bounds); });
  }
  /// Reads a struct with fields() and validates it.
  template <HasFields T>
  void read(const ConfigNode& n, T& value) {
    n.expect_map();
    ErrorList own;
    FieldReader reader(n, own);
    fields(reader, value);
    if constexpr (HasValidationError<T>) {
      const std::string wrong = own.none() ? validation_error(value) : "";
      if (!wrong.empty()) own.attempt([&] { n.fail_at_key(wrong); });
    }
    problems_.add(own);
  }

 private:
  static void read(const ConfigNode& n, bool& value) { value = n.boolean(); }
  static void read(const ConfigNode& n, int& value, const KeyBounds& bounds) {
    value = static_cast<int>(n.integer(bounds));
  }
  static void read(const ConfigNode& n, std::uint64_t& value) {
    const std::string word = n.text();
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      n.fail(fmt::format("must be a whole number from 0 to 2^64 - 1, not '{}'", word));
  }
  static void read(const ConfigNode& n, double& value, const KeyBounds& bounds) {
    value = n.number(bounds);
  }
  static void read(const ConfigNode& n, std::string& value) { value = n.text(); }
  static void read(const ConfigNode& n, Vec3& value, const KeyBounds& bounds) {
    value = n.vec3(bounds);
  }
  template <NamedEnum E>
  static void read(const ConfigNode& n, E& value) {
    const std::string word = n.text();
    const std::optional<E> known = enum_from_name<E>(word);
    if (!known) {
      constexpr auto names = names_of(E{});
      n.fail(fmt::format("must be {}, not '{}'{}", list_names<E>(), word,
                         renaming_hint(word, {names.begin(), names.end()})));
    }
    value = *known;
  }
  template <class T, class... Bounds>
  void read(const ConfigNode& n, std::vector<T>& values, const Bounds&... bounds) {
    values.clear();
    for (const ConfigNode& item : n.items())
      problems_.attempt([&] { read(item, values.emplace_back(), bounds...); });
  }
  template <class T, class... Bounds>
  void read(const ConfigNode& n, std::optional<T>& value, const Bounds&... bounds) {
    read(n, value.emplace(), bounds...);
  }

  ConfigNode node_;
  ErrorList& problems_;
};

/// Writes the fields of a struct as YAML.
class FieldWriter {
 public:
  /// `indent` is put in front of every line.
  explicit FieldWriter(std::string indent = "") : indent_(std::move(indent)) {}

  /// Writes a key and its value; an absent optional is omitted.
  template <class T, class... Bounds>
  void operator()(const char* key, T& value, const Bounds&...) {
    const std::string written = write(value, indent_ + "  ");
    if (!written.empty()) text += fmt::format("{}{}:{}\n", indent_, key, written);
  }
  /// Writes a key that has no default.
  template <class T, class... Bounds>
  void required(const char* key, T& value, const Bounds&...) {
    (*this)(key, value);
  }

  std::string text;

 private:
  static std::string write(bool value, const std::string&) { return value ? " true" : " false"; }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  static std::string write(Number value, const std::string&) { return fmt::format(" {}", value); }
  static std::string write(const std::string& value, const std::string&) {
    std::string quoted;
    for (const char c : value) quoted += c == '\'' ? std::string("''") : std::string(1, c);
    return fmt::format(" '{}'", quoted);
  }
  template <NamedEnum E>
  static std::string write(E value, const std::string& indent) {
    return write(std::string(name_of(value)), indent);
  }
  static std::string write(const Vec3& value, const std::string&) {
    return fmt::format(" [{}, {}, {}]", value.x(), value.y(), value.z());
  }
  template <class T>
  static std::string write(std::vector<T>& values, const std::string& indent) {
    if (values.empty()) return " []";
    std::string text;
    for (T& value : values) {
      std::string item = write(value, indent + "  ");
      if (item.starts_with('\n')) item = " " + item.substr(item.find_first_not_of("\n "));
      text += fmt::format("\n{}-{}", indent, item);
    }
    return text;
  }
  template <class T>
  static std::string write(std::optional<T>& value, const std::string& indent) {
    return value ? write(*value, indent) : "";
  }
  template <HasFields T>
  static std::string write(T& value, const std::string& indent) {
    FieldWriter inner(indent);
    fields(inner, value);
    if (inner.text.empty()) return " {}";
    inner.text.pop_back();
    return "\n" + inner.text;
  }

  std::string indent_;
};

/// Reads the options of a section; throws one InputError with all errors.
template <class Options>
void read_options(const ConfigNode& node, Options& options) {
  ErrorList problems;
  problems.attempt([&] { FieldReader(node, problems).read(node, options); });
  problems.throw_if_any();
}

/// Reads the options of a whole document; keys that are not part of them are errors too.
template <class Options>
void read_document(const ConfigNode& node, Options& options) {
  ErrorList problems;
  problems.attempt([&] { FieldReader(node, problems).read(node, options); });
  node.report_unread_keys(problems);
  problems.throw_if_any();
}

/// Returns the options as YAML.
template <class Options>
std::string write_options(const Options& options) {
  FieldWriter writer;
  Options copy = options;
  fields(writer, copy);
  return writer.text;
}

}  // namespace morphe::config
