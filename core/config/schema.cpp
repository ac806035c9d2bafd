#include "core/config/schema.hpp"

#include <cxxabi.h>

#include <cstdlib>

#include "core/config/spelling_hint.hpp"

namespace morphe::config {
namespace {

/// Allows "key:" without a value, which requests the default.
void allow_null(Schema& schema) {
  if (schema.contains("enum")) schema["enum"].push_back(nullptr);
  if (!schema.contains("type")) return;
  if (schema["type"].is_string()) schema["type"] = Schema::array({schema["type"]});
  schema["type"].push_back("null");
}

Schema with_bounds(Schema schema, const KeyBounds& bounds) {
  schema[bounds.lower_open ? "exclusiveMinimum" : "minimum"] = bounds.lower;
  schema[bounds.upper_open ? "exclusiveMaximum" : "maximum"] = bounds.upper;
  return schema;
}

void report_unknown_keys_below(const ConfigNode& node, const Schema& schema, ErrorList& problems) {
  if (node.is_list() && schema.contains("items"))
    for (const ConfigNode& item : node.items())
      report_unknown_keys_below(item, schema["items"], problems);
  if (!node.is_map() || !schema.contains("properties")) return;
  const Schema& known = schema["properties"];
  std::vector<std::string> names;
  for (const auto& [name, value] : known.items()) names.push_back(name);
  for (const std::string& key : node.keys())
    if (known.contains(key))
      report_unknown_keys_below(node[key], known[key], problems);
    else
      problems.attempt([&] { node[key].fail("unknown key" + spelling_hint(key, names)); });
}

}  // namespace

Schema number_schema(const KeyBounds& bounds) {
  return with_bounds({{"type", {"number", "string"}},
                      {"pattern", "^[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)? *(deg)?$"}},
                     bounds);
}

Schema integer_schema(const KeyBounds& bounds) {
  Schema schema = with_bounds({{"type", "integer"}}, bounds);
  for (auto& [key, value] : schema.items())
    if (value.is_number()) value = static_cast<std::int64_t>(value.get<double>());
  return schema;
}
Schema scalar_schema() { return {{"type", {"string", "number", "boolean"}}}; }
Schema boolean_schema() { return {{"type", "boolean"}}; }
Schema enum_schema(const std::vector<std::string>& words) { return {{"enum", words}}; }
Schema list_schema(const Schema& items) { return {{"type", "array"}, {"items", items}}; }

Schema list_schema(const Schema& items, std::size_t count) {
  return {{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}

Schema object_schema(const std::vector<SchemaKey>& keys) {
  Schema properties = Schema::object(), required = Schema::array();
  for (const SchemaKey& key : keys) {
    Schema schema;
    if (!key.description.empty()) schema["description"] = key.description;
    schema.update(key.schema);
    if (key.required) required.push_back(key.name);
    if (!key.required) allow_null(schema);
    properties[key.name] = std::move(schema);
  }
  Schema schema{
      {"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

Schema schema_document(const std::string& title, Schema schema) {
  Schema document{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  document.update(schema);
  return document;
}

void report_unknown_keys(const ConfigNode& node, const Schema& schema, ErrorList& problems) {
  // The copy keeps these reads from marking keys as read.
  report_unknown_keys_below(node.copy_as_document(), schema, problems);
}

std::string type_name(const std::type_info& type) {
  char* const plain = abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr);
  const std::string name = plain ? plain : type.name();
  std::free(plain);
  return name.substr(name.rfind(':') + 1);
}

}  // namespace morphe::config
