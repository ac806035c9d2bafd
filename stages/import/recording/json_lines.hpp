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
  std::string file;                       ///< file name for messages
  std::size_t line = 0;                   ///< 0 for the whole file
  std::string key;                        ///< "" at the top level
  const nlohmann::json* value = nullptr;  ///< the value itself

  /// Throws InputError "FILE:LINE: KEY: message".
  [[noreturn]] void fail(const std::string& message) const;
  /// Returns true if the object has a member of that name.
  bool has(const std::string& name) const;
  /// Returns a member; fails if the value is not an object or lacks it.
  JsonNode at(const std::string& name) const;
  double number() const;  ///< finite
  /// Returns the given number of finite numbers of a list, in any nesting; fails if there are other
  /// values, or more or fewer.
  std::vector<double> numbers(std::size_t count) const;
  /// Returns three finite numbers.
  Vec3 point() const;
  /// Returns the text; fails for another type.
  std::string text() const;
  Quat quaternion() const;  ///< w, x, y, z of unit norm
};

/// Calls `visit` for each line that is not blank. Throws InputError for a file that cannot be read
/// and for a line that is not a JSON object.
void each_json_line(const std::filesystem::path& file,
                    const std::function<void(const JsonNode&)>& visit);

/// Reads the whole file as one value. Throws InputError as above.
nlohmann::json read_json(const std::filesystem::path& file);

}  // namespace morphe::imports
