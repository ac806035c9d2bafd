#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/parquet/column.hpp"

namespace morphe::parquet {

/// The cells of one column in one row group, encoded as they come.
///
/// A cell is optional, and so is an element of a list: the definition level of a value is the
/// largest one (1, in a list 3), that of a null 0, of an empty list 1 and of a null in a list 2.
/// The repetition level of an element is 1 unless it is the first of its row.
class ColumnChunk {
 public:
  explicit ColumnChunk(const Column& column) : type_(column.type), is_list_(column.is_list) {}

  /// Appends a cell of a column without lists; the type must be that of the column, `number` for
  /// both floating-point ones. A number that is NaN is null.
  void add_boolean(bool value);
  void add_integer(std::int64_t value);
  void add_number(double value);
  void add_text(std::string_view value);
  /// Appends a cell without a value.
  void add_null();
  /// Appends a list; numbers that are NaN are null.
  void add_integers(std::span<const std::int64_t> values);
  void add_numbers(std::span<const double> values);
  void add_texts(std::span<const std::string> values);

  /// Returns the number of bytes of the page so far, up to its levels' compression.
  std::size_t size() const { return values_.size() + definition_.size() + repetition_.size(); }
  /// Returns the number of values, nulls and empty lists included.
  std::size_t value_count() const { return definition_.size(); }
  /// Returns the body of a data page of version 1 with all cells: levels and plain values.
  std::string page_body() const;
  /// Removes all cells.
  void clear();

 private:
  void define(std::uint8_t definition, bool is_first);
  void append_number(double value);
  template <class Values, class Append>
  void add_list(const Values& values, const Append& append);

  ValueType type_;
  bool is_list_;
  std::string values_;                    ///< plain, except booleans: a byte each
  std::vector<std::uint8_t> definition_;  ///< levels, one per value, null and empty list
  std::vector<std::uint8_t> repetition_;  ///< likewise; empty without lists
};

/// Returns levels of `bit_width` bits as a data page of version 1 has them: the number of bytes,
/// then one run of equal levels, or one of packed bits.
std::string encode_levels(std::span<const std::uint8_t> levels, int bit_width);

}  // namespace morphe::parquet
