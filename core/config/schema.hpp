#pragma once

#include <concepts>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "core/config/fields.hpp"

namespace morphe::config {

/// A JSON Schema (draft 2020-12) of what a YAML file may hold, for editors and other checkers.
using Schema = nlohmann::ordered_json;

Schema number_schema();  ///< also "177 deg"
Schema whole_number_schema();
Schema text_schema();  ///< any single value: YAML needs no quotes
Schema truth_schema();
Schema choice_schema(const std::vector<std::string>& words);
Schema list_schema(const Schema& items);
Schema list_schema(const Schema& items, std::size_t count);

/// A key of a map, in the file's words.
struct SchemaKey {
  std::string name;
  Schema schema;
  std::string meaning;
  bool required = false;
};
/// A map of these keys and no others. One that is not required may stand without a value.
Schema map_schema(const std::vector<SchemaKey>& keys);

/// As a file: with a title, and what kind of schema it is.
Schema schema_document(const std::string& title, Schema schema);

/// Every key of the document that its schema does not have, with the one that was probably meant.
void add_strangers(const ConfigNode& node, const Schema& schema, Problems& problems);

/// What a key of an options struct means ("MapOptions", "starts"), "" if nobody says.
using Meanings = std::function<std::string(const std::string&, const std::string&)>;

/// "morphe::map::MapOptions" -> "MapOptions".
std::string type_name(const std::type_info& type);

/// The third that reads an options struct's fields(), beside FieldReader and FieldWriter: its
/// schema, with the struct's values as defaults. Numbers have the bounds 0 and 1 where the struct's
/// own why_invalid() says so.
class FieldSchema {
 public:
  /// `partial`: what is required may come from a base that a config extends.
  FieldSchema(std::string type, const Meanings& meanings, bool partial,
              std::function<std::string()> why)
      : type_(std::move(type)), meanings_(meanings), partial_(partial), why_(std::move(why)) {}

  template <class T>
  void operator()(const char* key, T& value) {
    keys_.push_back({key, of(value), meanings_(type_, key), false});
    add_default(value, keys_.back().schema);
  }
  template <class T>
  void required(const char* key, T& value) {
    keys_.push_back({key, of(value), meanings_(type_, key), true});
  }
  Schema schema() {
    // A section of one key is never completed by a base.
    for (SchemaKey& key : keys_) key.required &= !partial_ || keys_.size() == 1;
    return map_schema(keys_);
  }

  template <HasFields T>
  static Schema of_struct(T& value, const Meanings& meanings, bool partial) {
    std::function<std::string()> why;
    if constexpr (HasWhyInvalid<T>) why = [&value] { return why_invalid(value); };
    FieldSchema inner(type_name(typeid(T)), meanings, partial, std::move(why));
    fields(inner, value);
    return inner.schema();
  }

 private:
  Schema of(bool&) const { return truth_schema(); }
  Schema of(int& value) const { return bounded(whole_number_schema(), value, 1); }
  Schema of(std::uint64_t&) const {
    Schema schema = whole_number_schema();
    schema["minimum"] = 0;
    return schema;
  }
  Schema of(double& value) const { return bounded(number_schema(), value, 1e-9); }
  Schema of(std::string&) const { return text_schema(); }
  Schema of(Vec3&) const { return list_schema(number_schema(), 3); }
  template <Named E>
  Schema of(E&) const {
    constexpr auto names = names_of(E{});
    return choice_schema({names.begin(), names.end()});
  }
  template <class T>
  Schema of(std::vector<T>&) const {
    T item{};
    if constexpr (HasFields<T>) return list_schema(of_struct(item, meanings_, false));
    return list_schema(FieldSchema("", meanings_, false, {}).of(item));
  }
  template <class T>
  Schema of(std::optional<T>&) const {
    T value{};
    return FieldSchema("", meanings_, partial_, {}).of(value);
  }
  template <HasFields T>
  Schema of(T& value) const {
    return of_struct(value, meanings_, partial_);
  }

  /// Which of 0, 0.001 and 1 the struct's check lets a number come to, found by asking it.
  template <class Number>
  Schema bounded(Schema schema, Number& value, double step) const {
    if (!why_ || !why_().empty()) return schema;
    const Number kept = value;
    const auto holds = [&](double tried) {
      value = static_cast<Number>(tried);
      const bool fine = why_().empty();
      value = kept;
      return fine;
    };
    for (const double bound : {0.0, std::integral<Number> ? 1.0 : 1e-3}) {
      if (!holds(bound - step) && holds(bound) && holds(bound + step)) schema["minimum"] = bound;
    }
    if constexpr (!std::integral<Number>) {
      if (!holds(0) && holds(step) && holds(2 * step)) schema["exclusiveMinimum"] = 0;
      if (!holds(1 + step) && holds(1) && holds(1 - step)) schema["maximum"] = 1;
      if (!holds(1) && holds(1 - step) && holds(1 - 2 * step)) schema["exclusiveMaximum"] = 1;
    }
    return schema;
  }

  template <class T>
  static void add_default(const T& value, Schema& schema) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
      if (value != T{} || !std::is_same_v<T, std::string>) schema["default"] = value;
    } else if constexpr (std::is_same_v<T, Vec3>) {
      schema["default"] = {value.x(), value.y(), value.z()};
    } else if constexpr (Named<T>) {
      schema["default"] = name_of(value);
    }
  }

  std::string type_;
  const Meanings& meanings_;
  bool partial_;
  std::function<std::string()> why_;
  std::vector<SchemaKey> keys_;
};

/// Of a struct that a file holds as a whole, or as a section.
template <HasFields T>
Schema schema_of(const Meanings& meanings, bool partial = false) {
  T value{};
  return FieldSchema::of_struct(value, meanings, partial);
}

}  // namespace morphe::config
