#pragma once

#include <cstdint>
#include <string>

namespace morphe::parquet {

/// The type of the values of a column: BOOLEAN, INT64, FLOAT, DOUBLE, BYTE_ARRAY of UTF-8.
enum class ValueType : std::uint8_t { boolean, int64, float32, float64, text };

/// A column of a table. Every cell is a value, or a list of values, or null.
struct Column {
  std::string name;  ///< UTF-8; a dot or slash is an ordinary character
  ValueType type = ValueType::float64;
  bool is_list = false;
};

/// An entry of a file's metadata, for readers that know the key.
struct KeyValue {
  std::string key, value;
};

}  // namespace morphe::parquet
