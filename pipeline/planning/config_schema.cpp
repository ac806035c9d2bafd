#include "pipeline/planning/config_schema.hpp"

#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

config::Schema config_schema(const config::KeyDescriptions& meanings) {
  config::Schema schema = config::schema_of<PipelineConfig>(meanings, true);
  schema["properties"]["extends"] = config::object_schema(
      {{"extends", config::scalar_schema(),
        "a config that says what this one leaves out, relative to it"}})["properties"]["extends"];
  config::Schema entry = schema;
  entry["properties"].erase("dataset");
  entry["properties"]["name"] = config::scalar_schema();
  entry["properties"]["name"]["description"] =
      "of the robot's folder: letters, digits, '_', '-' and '+'";
  entry["required"] = {"name"};
  schema["properties"]["robots"] = config::list_schema(entry);
  schema["properties"]["robots"]["description"] =
      "the config of each of several robots, on the same recordings";
  // A config that extends another takes the robot from there.
  const auto has = [](const char* key) { return config::Schema{{"required", {key}}}; };
  schema["if"] = {{"not", {{"anyOf", {has("extends"), has("robots")}}}}};
  schema["then"] = has("robot");
  return schema;
}

}  // namespace morphe::planning
