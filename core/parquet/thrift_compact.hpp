#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::parquet {

/// Appends an unsigned integer in groups of 7 bits, lowest first (ULEB128).
void append_varint(std::uint64_t value, std::string& bytes);

/// Writes structs in Thrift's compact protocol. The fields of a struct come in the order of their
/// ids. Lists are begun with their length; then each element is written.
class ThriftWriter {
 public:
  /// The types of fields and elements.
  enum class Type : std::uint8_t { i32 = 5, i64 = 6, binary = 8, list = 9, structure = 12 };

  /// Writes a field of type i32 or i64.
  void integer(int id, Type type, std::int64_t value);
  /// Writes a field with a text.
  void text(int id, std::string_view value);
  /// Begins a field with a list of `size` elements.
  void begin_list(int id, Type element, std::size_t size);
  /// Writes an element of a list of integers.
  void integer_element(std::int64_t value);
  /// Writes an element of a list of texts.
  void text_element(std::string_view value);
  /// Begins a field that is a struct, or an element of a list of structs.
  void begin_struct(int id);
  void begin_struct_element();
  /// Ends the innermost struct; the outermost one too is ended so.
  void end_struct();

  /// Returns the bytes.
  const std::string& bytes() const { return bytes_; }

 private:
  void field(int id, Type type);

  std::string bytes_;
  std::vector<int> last_id_{0};  ///< of each struct that is open
};

}  // namespace morphe::parquet
