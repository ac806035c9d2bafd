#pragma once

#include <concepts>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <typeinfo>
#include <vector>

#include "core/config/fields.hpp"

namespace morphe::config {

/// A JSON Schema (draft 2020-12) of the permitted content of a YAML file.
using Schema = nlohmann::ordered_json;

/// Returns the schema of a number within bounds, which includes "177 deg".
Schema number_schema(const KeyBounds& bounds);
/// Returns the schema of an integer within bounds.
Schema integer_schema(const KeyBounds& bounds);
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
/// defaults.
class FieldSchema {
 public:
  /// `partial`: required keys may come from a base that a config extends.
  FieldSchema(std::string type, const KeyDescriptions& meanings, bool partial)
      : type_(std::move(type)), meanings_(meanings), partial_(partial) {}

  /// Adds a key with its default; numbers have bounds.
  template <class T, class... Bounds>
  void operator()(const char* key, T& value, const Bounds&... bounds) {
    keys_.push_back({key, value_schema(value, bounds...), meanings_(type_, key), false});
    add_default(value, keys_.back().schema);
  }
  /// Adds a key that has no default.
  template <class T, class... Bounds>
  void required(const char* key, T& value, const Bounds&... bounds) {
    keys_.push_back({key, value_schema(value, bounds...), meanings_(type_, key), true});
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
    FieldSchema inner(type_name(typeid(T)), meanings, partial);
    fields(inner, value);
    return inner.schema();
  }

 private:
  Schema value_schema(bool&) const { return boolean_schema(); }
  Schema value_schema(int&, const KeyBounds& bounds) const { return integer_schema(bounds); }
  Schema value_schema(std::uint64_t&) const {
    return {{"type", "integer"},
            {"minimum", 0},
            {"maximum", std::numeric_limits<std::uint64_t>::max()}};
  }
  Schema value_schema(double&, const KeyBounds& bounds) const { return number_schema(bounds); }
  Schema value_schema(std::string&) const { return scalar_schema(); }
  Schema value_schema(Vec3&, const KeyBounds& bounds) const {
    return list_schema(number_schema(bounds), 3);
  }
  template <NamedEnum E>
  Schema value_schema(E&) const {
    constexpr auto names = names_of(E{});
    return enum_schema({names.begin(), names.end()});
  }
  template <class T, class... Bounds>
  Schema value_schema(std::vector<T>&, const Bounds&... bounds) const {
    T item{};
    return list_schema(FieldSchema("", meanings_, false).value_schema(item, bounds...));
  }
  template <class T, class... Bounds>
  Schema value_schema(std::optional<T>&, const Bounds&... bounds) const {
    T value{};
    return value_schema(value, bounds...);
  }
  template <HasFields T>
  Schema value_schema(T& value) const {
    return struct_schema(value, meanings_, partial_);
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
  std::vector<SchemaKey> keys_;
};

/// Returns the schema of a struct that a file contains as a whole or as a section.
template <HasFields T>
Schema schema_of(const KeyDescriptions& meanings, bool partial = false) {
  T value{};
  return FieldSchema::struct_schema(value, meanings, partial);
}

}  // namespace morphe::config
