#pragma once

#include <fmt/format.h>

#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/node.hpp"
#include "core/motion/named.hpp"

namespace morphe::config {

/// Options structs describe themselves once, for reading and for writing:
///
///     struct SegmentOptions { double onset_share = 0.05; };
///     template <class Fields>
///     void fields(Fields& f, SegmentOptions& o) { f("onset_share", o.onset_share); }
///     std::string why_invalid(const SegmentOptions& o);   // optional: "" or what is wrong
///
/// read_options(node, options) leaves defaults where a key is absent and throws one InputError of
/// all that is wrong, a line each; write_options gives YAML that read_options takes back to the
/// same values. Supported: bool, int, std::uint64_t, double, std::string, Vec3, named enumerations,
/// vectors and optionals of these, and structs with fields() of their own.
class FieldReader;
class FieldWriter;

template <class T>
concept HasFields = requires(FieldWriter& f, T& options) {
  fields(f, options);
};
template <class T>
concept HasWhyInvalid = requires(const T& options) {
  { why_invalid(options) } -> std::same_as<std::string>;
};

template <class Options>
void read_options(const ConfigNode& node, Options& options);
/// The same for a whole document: a key that is none of theirs is wrong, too.
template <class Options>
void read_document(const ConfigNode& node, Options& options);
template <class Options>
std::string write_options(const Options& options);

/// Adds what is wrong to `problems` and goes on with the next key.
class FieldReader {
 public:
  FieldReader(ConfigNode node, Problems& problems) : node_(std::move(node)), problems_(problems) {}

  template <class T>
  void operator()(const char* key, T& value) {
    if (node_.has(key)) required(key, value);
  }
  /// A key without a default.
  template <class T>
  void required(const char* key, T& value) {
    problems_.attempt([&] { read(node_[key], value); });
  }
  template <HasFields T>
  void read(const ConfigNode& n, T& value) {
    n.expect_map();
    Problems own;
    FieldReader reader(n, own);
    fields(reader, value);
    if constexpr (HasWhyInvalid<T>) {
      const std::string wrong = own.none() ? why_invalid(value) : "";
      if (!wrong.empty()) own.attempt([&] { n.fail_below(wrong); });
    }
    problems_.add(own);
  }

 private:
  static void read(const ConfigNode& n, bool& value) { value = n.boolean(); }
  static void read(const ConfigNode& n, int& value) {
    const std::int64_t number = n.integer();
    value = static_cast<int>(number);
    if (value != number) n.fail(fmt::format("is out of range: {}", number));
  }
  static void read(const ConfigNode& n, std::uint64_t& value) {
    const std::string word = n.text();
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      n.fail(fmt::format("must be a whole number from 0 to 2^64 - 1, not '{}'", word));
    }
  }
  static void read(const ConfigNode& n, double& value) { value = n.number(); }
  static void read(const ConfigNode& n, std::string& value) { value = n.text(); }
  static void read(const ConfigNode& n, Vec3& value) { value = n.vec3(); }
  template <Named E>
  static void read(const ConfigNode& n, E& value) {
    const std::string word = n.text();
    const std::optional<E> known = named<E>(word);
    if (!known) n.fail(fmt::format("must be {}, not '{}'", choice_of<E>(), word));
    value = *known;
  }
  template <class T>
  void read(const ConfigNode& n, std::vector<T>& values) {
    values.clear();
    for (const ConfigNode& item : n.items()) {
      problems_.attempt([&] { read(item, values.emplace_back()); });
    }
  }
  template <class T>
  void read(const ConfigNode& n, std::optional<T>& value) {
    read(n, value.emplace());
  }

  ConfigNode node_;
  Problems& problems_;
};

class FieldWriter {
 public:
  explicit FieldWriter(std::string indent = "") : indent_(std::move(indent)) {}

  template <class T>
  void operator()(const char* key, T& value) {
    const std::string written = write(value, indent_ + "  ");
    if (!written.empty()) text += fmt::format("{}{}:{}\n", indent_, key, written);
  }
  template <class T>
  void required(const char* key, T& value) {
    (*this)(key, value);
  }

  std::string text;

 private:
  static std::string write(bool value, const std::string&) { return value ? " true" : " false"; }
  static std::string write(int value, const std::string&) { return fmt::format(" {}", value); }
  static std::string write(std::uint64_t value, const std::string&) {
    return fmt::format(" {}", value);
  }
  static std::string write(double value, const std::string&) { return fmt::format(" {}", value); }
  static std::string write(const std::string& value, const std::string&) {
    std::string quoted;
    for (const char c : value) quoted += c == '\'' ? std::string("''") : std::string(1, c);
    return fmt::format(" '{}'", quoted);
  }
  template <Named E>
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

template <class Options>
void read_options(const ConfigNode& node, Options& options) {
  Problems problems;
  problems.attempt([&] { FieldReader(node, problems).read(node, options); });
  problems.throw_any();
}

template <class Options>
void read_document(const ConfigNode& node, Options& options) {
  Problems problems;
  problems.attempt([&] { FieldReader(node, problems).read(node, options); });
  node.add_unread(problems);
  problems.throw_any();
}

template <class Options>
std::string write_options(const Options& options) {
  FieldWriter writer;
  Options copy = options;
  fields(writer, copy);
  return writer.text;
}

}  // namespace morphe::config
