#pragma once

#include <concepts>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <typeinfo>
#include <vector>

#include "core/config/fields.hpp"

namespace morphe::config {

/// A JSON Schema (draft 2020-12) of the permitted content of a YAML file.
using Schema = nlohmann::ordered_json;

/// Returns the schema of a number, which includes "177 deg".
Schema number_schema();
/// Returns the schema of an integer.
Schema integer_schema();
/// Returns the schema of a text, which is any scalar, because texts in YAML need no quotes.
Schema scalar_schema();
/// Returns the schema of a boolean.
Schema boolean_schema();
/// Returns the schema of an enumeration.
Schema enum_schema(const std::vector<std::string>& words);
/// Returns the schema of a list.
Schema list_schema(const Schema& items);
/// Returns the schema of a list with `count` items.
Schema list_schema(const Schema& items, std::size_t count);

/// A key of a map in a file.
struct SchemaKey {
  std::string name;
  Schema schema;
  std::string description;
  bool required = false;
};
/// Returns the schema of a map with only these keys; those that are not required may have no value.
Schema object_schema(const std::vector<SchemaKey>& keys);

/// Returns the schema of a whole file, with a title and the version of JSON Schema.
Schema schema_document(const std::string& title, Schema schema);

/// Adds keys that the schema does not have to the errors, each with the most similar permitted key.
void report_unknown_keys(const ConfigNode& node, const Schema& schema, ErrorList& problems);

/// Returns the description of an options struct's key ("MapOptions", "starts"), or "".
using KeyDescriptions = std::function<std::string(const std::string&, const std::string&)>;

/// Returns the unqualified name of a type: "morphe::map::MapOptions" -> "MapOptions".
std::string type_name(const std::type_info& type);

/// Builds the schema of an options struct from its fields(). The values of the struct are the
/// defaults; numbers get the bounds 0, 0.001 and 1 if its validation_error() enforces them.
class FieldSchema {
 public:
  /// `partial`: required keys may come from a base that a config extends.
  FieldSchema(std::string type, const KeyDescriptions& meanings, bool partial,
              std::function<std::string()> why)
      : type_(std::move(type)), meanings_(meanings), partial_(partial), validate_(std::move(why)) {}

  /// Adds a key with its default.
  template <class T>
  void operator()(const char* key, T& value) {
    keys_.push_back({key, value_schema(value), meanings_(type_, key), false});
    add_default(value, keys_.back().schema);
  }
  /// Adds a key that has no default.
  template <class T>
  void required(const char* key, T& value) {
    keys_.push_back({key, value_schema(value), meanings_(type_, key), true});
  }
  /// Returns the schema of all keys added so far.
  Schema schema() {
    // A section with a single key is never completed by a base.
    for (SchemaKey& key : keys_) key.required &= !partial_ || keys_.size() == 1;
    return object_schema(keys_);
  }

  /// Returns the schema of a struct.
  template <HasFields T>
  static Schema struct_schema(T& value, const KeyDescriptions& meanings, bool partial) {
    std::function<std::string()> validate;
    if constexpr (HasValidationError<T>) validate = [&value] { return validation_error(value); };
    FieldSchema inner(type_name(typeid(T)), meanings, partial, std::move(validate));
    fields(inner, value);
    return inner.schema();
  }

 private:
  Schema value_schema(bool&) const { return boolean_schema(); }
  Schema value_schema(int& value) const { return with_bounds(integer_schema(), value, 1); }
  Schema value_schema(std::uint64_t&) const {
    Schema schema = integer_schema();
    schema["minimum"] = 0;
    return schema;
  }
  Schema value_schema(double& value) const { return with_bounds(number_schema(), value, 1e-9); }
  Schema value_schema(std::string&) const { return scalar_schema(); }
  Schema value_schema(Vec3&) const { return list_schema(number_schema(), 3); }
  template <NamedEnum E>
  Schema value_schema(E&) const {
    constexpr auto names = names_of(E{});
    return enum_schema({names.begin(), names.end()});
  }
  template <class T>
  Schema value_schema(std::vector<T>&) const {
    T item{};
    if constexpr (HasFields<T>) return list_schema(struct_schema(item, meanings_, false));
    return list_schema(FieldSchema("", meanings_, false, {}).value_schema(item));
  }
  template <class T>
  Schema value_schema(std::optional<T>&) const {
    T value{};
    return FieldSchema("", meanings_, partial_, {}).value_schema(value);
  }
  template <HasFields T>
  Schema value_schema(T& value) const {
    return struct_schema(value, meanings_, partial_);
  }

  /// Adds the bounds 0, 0.001 and 1 that validation_error() enforces, found by trying values.
  template <class Number>
  Schema with_bounds(Schema schema, Number& value, double step) const {
    if (!validate_ || !validate_().empty()) return schema;
    const Number kept = value;
    const auto holds = [&](double tried) {
      value = static_cast<Number>(tried);
      const bool valid = validate_().empty();
      value = kept;
      return valid;
    };
    for (const double bound : {0.0, std::integral<Number> ? 1.0 : 1e-3})
      if (!holds(bound - step) && holds(bound) && holds(bound + step)) schema["minimum"] = bound;
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
    } else if constexpr (NamedEnum<T>) {
      schema["default"] = name_of(value);
    }
  }

  std::string type_;
  const KeyDescriptions& meanings_;
  bool partial_;
  std::function<std::string()> validate_;
  std::vector<SchemaKey> keys_;
};

/// Returns the schema of a struct that a file contains as a whole or as a section.
template <HasFields T>
Schema schema_of(const KeyDescriptions& meanings, bool partial = false) {
  T value{};
  return FieldSchema::struct_schema(value, meanings, partial);
}

}  // namespace morphe::config
