#include "pipeline/planning/config_schema.hpp"

#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {

config::Schema config_schema(const config::KeyDescriptions& meanings) {
  config::Schema schema = config::schema_of<PipelineConfig>(meanings, true);
  schema["properties"]["extends"] = config::object_schema(
      {{"extends", config::scalar_schema(),
        "config for the keys missing here; path relative to this file"}})["properties"]["extends"];
  config::Schema entry = schema;
  entry["properties"].erase("dataset");
  entry["properties"]["name"] = config::scalar_schema();
  entry["properties"]["name"]["description"] =
      "name of the robot's folder: letters, digits, '_', '-' and '+'";
  entry["required"] = {"name"};
  schema["properties"]["robots"] = config::list_schema(entry);
  schema["properties"]["robots"]["description"] = "one config per robot, for the same recordings";
  // A config that extends another takes the robot from there.
  const auto has = [](const char* key) { return config::Schema{{"required", {key}}}; };
  schema["if"] = {{"not", {{"anyOf", {has("extends"), has("robots")}}}}};
  schema["then"] = has("robot");
  return schema;
}

}  // namespace morphe::planning
