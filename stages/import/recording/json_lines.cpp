#include "stages/import/recording/json_lines.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/motion/input_error.hpp"

namespace morphe::imports {
namespace {

void append_numbers(const JsonNode& place, const nlohmann::json& value,
                    std::vector<double>& numbers) {
  if (value.is_array()) {
    for (const nlohmann::json& entry : value) append_numbers(place, entry, numbers);
    return;
  }
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    place.fail("must contain only finite numbers");
  numbers.push_back(value.get<double>());
}

std::ifstream open(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code error;
  if (!stream || std::filesystem::is_directory(file, error))
    throw InputError(fmt::format("{}: cannot be read", file.string()));
  return stream;
}

}  // namespace

void JsonNode::fail(const std::string& message) const {
  const std::string where = line > 0 ? fmt::format("{}:{}", file, line) : file;
  throw InputError(key.empty() ? fmt::format("{}: {}", where, message)
                               : fmt::format("{}: {}: {}", where, key, message));
}

bool JsonNode::has(const std::string& name) const {
  return value->is_object() && value->contains(name);
}

JsonNode JsonNode::at(const std::string& name) const {
  JsonNode member{file, line, key.empty() ? name : key + "." + name, nullptr};
  if (!has(name)) member.fail("is missing");
  member.value = &value->at(name);
  return member;
}

double JsonNode::number() const { return numbers(1)[0]; }

std::vector<double> JsonNode::numbers(std::size_t count) const {
  std::vector<double> all;
  append_numbers(*this, *value, all);
  if (all.size() != count) fail(fmt::format("must have {} numbers, not {}", count, all.size()));
  return all;
}

Vec3 JsonNode::point() const {
  const std::vector<double> p = numbers(3);
  return {p[0], p[1], p[2]};
}

std::string JsonNode::text() const {
  if (!value->is_string()) fail("must be text");
  return value->get<std::string>();
}

Quat JsonNode::quaternion() const {
  const std::vector<double> q = numbers(4);
  const Quat rotation(q[0], q[1], q[2], q[3]);
  if (!(std::abs(rotation.norm() - 1) < 0.01)) fail("is not a quaternion of unit length");
  return rotation.normalized();
}

void each_json_line(const std::filesystem::path& file,
                    const std::function<void(const JsonNode&)>& visit) {
  std::ifstream stream = open(file);
  std::string text;
  for (std::size_t line = 1; std::getline(stream, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    JsonNode place{file.string(), line, "", nullptr};
    const nlohmann::json value = nlohmann::json::parse(text, nullptr, false);
    if (!value.is_object()) place.fail("is not a JSON object: the line is damaged or cut off");
    place.value = &value;
    visit(place);
  }
}

nlohmann::json read_json(const std::filesystem::path& file) {
  std::ifstream stream = open(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  nlohmann::json value = nlohmann::json::parse(text, nullptr, false);
  if (!value.is_object()) {
    JsonNode{file.string(), 0, "", nullptr}.fail(
        "is not a JSON object: the file is damaged or cut off");
  }
  return value;
}

}  // namespace morphe::imports
