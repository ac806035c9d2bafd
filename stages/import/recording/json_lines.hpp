#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// A value of JSON and where it stands.
struct JsonPlace {
  std::string file;
  std::size_t line = 0;  ///< 0 = the whole file
  std::string key;       ///< "" = the top
  const nlohmann::json* value = nullptr;

  /// InputError "FILE:LINE: KEY: message".
  [[noreturn]] void fail(const std::string& message) const;
  bool has(const std::string& name) const;
  /// A member; fails if the value is no object or lacks it.
  JsonPlace at(const std::string& name) const;
  double number() const;  ///< finite
  /// So many finite numbers of a list, in any nesting; fails if there are others or more or fewer.
  std::vector<double> numbers(std::size_t count) const;
  Vec3 point() const;
  std::string text() const;
  Quat quaternion() const;  ///< w, x, y, z of unit norm
};

/// Shows each line that is not blank. InputError for a file that cannot be read and a line that is
/// no object of JSON.
void each_json_line(const std::filesystem::path& file,
                    const std::function<void(const JsonPlace&)>& visit);

/// The whole file as one value. InputError as above.
nlohmann::json read_json(const std::filesystem::path& file);

}  // namespace morphe::imports
