#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// A value of JSON and its location.
struct JsonNode {
  std::string file;      ///< name for messages
  std::size_t line = 0;  ///< 0 for the whole file
  std::string key;       ///< its keys, such as "a.b"; "" at the top level
  const nlohmann::json* value = nullptr;

  /// Throws InputError "FILE:LINE: KEY: message", without LINE if it is 0 and KEY if it is "".
  [[noreturn]] void fail(const std::string& message) const;
  bool has(const std::string& name) const;  ///< true for an object with a member of that name
  // The following throw InputError if the value is missing or not of the described form.
  JsonNode at(const std::string& name) const;  ///< a member of an object
  double number() const;                       ///< a finite number, bare or alone in a list
  std::vector<double> numbers(std::size_t count) const;  ///< `count` finite ones, flattened
  Vec3 point() const;                                    ///< numbers(3)
  std::string text() const;
  Quat quaternion() const;  ///< w, x, y, z of norm 1 within 1 %; returned normalised
};

/// Calls `visit` for each line that is not blank. Throws InputError for a file that cannot be read
/// and for a line that is not a JSON object.
void each_json_line(const std::filesystem::path& file,
                    const std::function<void(const JsonNode&)>& visit);

/// Reads the whole file as one JSON object. Throws InputError as above.
nlohmann::json read_json(const std::filesystem::path& file);

}  // namespace morphe::imports
