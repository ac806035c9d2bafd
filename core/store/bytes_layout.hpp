#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/motion/input_error.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// Reports errors of the classes below by throwing InputError.
struct BytesPlace {
  [[noreturn]] void fail(const std::string& message) const { throw InputError(message); }
};

/// Appends the items of a layout to a byte string. This is the form of the layouts of the files
/// (layout.hpp) as plain bytes instead of HDF5, for hashing and for the journal of a run. Equal
/// values give equal bytes. Every item is preceded by its name; numbers are little-endian as in
/// memory.
class BytesWriter {
 public:
  static constexpr bool reading = false;
  explicit BytesWriter(std::string& bytes) : bytes_(bytes) {}
  /// Returns an object that reports errors.
  BytesPlace current_group() const { return {}; }

  /// Writes a dataset.
  template <class T>
  void dataset(const char* name, const T& values, const DatasetAttributes&) {
    begin(name);
    const auto array = ArrayCodec<T>::encode(values);
    put(array.dims.size());
    for (const std::size_t dim : array.dims) put(dim);
    put_raw(array.values.data(), array.values.size() * sizeof(array.values[0]));
  }
  /// Writes a dataset if `present` is true.
  template <class T>
  void dataset_if(bool present, const char* name, const T& values, const DatasetAttributes& tags) {
    if (present) dataset(name, values, tags);
  }
  /// Writes a dataset of names.
  void names(const char* name, const std::vector<std::string>& values) { attribute(name, values); }
  /// Writes names unless there are no names.
  void optional_names(const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) names(name, values);
  }
  /// Writes one member of all rows.
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes&) {
    begin(name);
    put(rows.size());
    for (const Row& row : rows) put_item(row.*member);
  }
  /// Writes one member of all rows if `present` is true.
  template <class Row, class Member>
  void column_if(bool present, const char* name, const std::vector<Row>& rows, Member Row::*member,
                 const DatasetAttributes& tags) {
    if (present) column(name, rows, member, tags);
  }
  /// Writes an attribute.
  template <class T>
  void attribute(const char* name, const T& value) {
    begin(name);
    put_item(value);
  }
  /// Writes a flag, which is stored only if it is true.
  void optional_flag(const char* name, bool value) {
    if (value) attribute(name, value);
  }
  /// Writes an optional attribute.
  template <class T>
  void optional_attribute(const char* name, const T& value) {
    attribute(name, value);
  }
  /// Writes an optional attribute.
  template <class T>
  void optional_attribute(const char* name, const std::optional<T>& value) {
    if (value) attribute(name, *value);
  }
  /// Writes a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    begin(name);
    body(*this);
  }
  /// Writes a group if `present` is true.
  template <class Body>
  void group_if(bool present, const char* name, const Body& body) {
    if (present) group(name, body);
  }
  /// Writes one group for each item.
  template <class Item, class Body>
  void each(const std::vector<Item>& items, const Body& body) {
    put(items.size());
    for (const Item& item : items) group(item.name, [&](BytesWriter& in) { body(in, item); });
  }

 private:
  void begin(std::string_view name) { put_text(name); }
  void put(std::uint64_t number) { put_raw(&number, sizeof number); }
  void put_raw(const void* data, std::size_t count) {
    if (count > 0) bytes_.append(static_cast<const char*>(data), count);
  }
  void put_text(std::string_view text) {
    put(text.size());
    put_raw(text.data(), text.size());
  }
  template <class T>
  void put_item(const T& value) {
    if constexpr (std::is_convertible_v<T, std::string_view>) {
      put_text(value);
    } else if constexpr (std::is_same_v<T, bool>) {
      put_item(std::uint8_t{value});
    } else if constexpr (NamedEnum<T>) {
      put_text(name_of(value));
    } else {
      using Codec = ItemCodec<T>;
      typename Codec::Scalar scalars[Codec::size];
      Codec::encode(value, scalars);
      put_raw(scalars, sizeof scalars);
    }
  }
  template <class T>
  void put_item(const std::vector<T>& values) {
    put(values.size());
    for (const T& value : values) put_item(value);
  }

  std::string& bytes_;
};

/// Reads the items of a layout from a byte string. Bytes that do not contain the requested data
/// throw InputError.
class BytesReader {
 public:
  static constexpr bool reading = true;
  explicit BytesReader(std::string_view bytes) : bytes_(bytes) {}
  /// Returns an object that reports errors.
  BytesPlace current_group() const { return {}; }
  bool at_end() const { return bytes_.empty(); }

  /// Reads a dataset.
  template <class T>
  void dataset(const char* name, T& values, const DatasetAttributes&) {
    expect(name);
    using Codec = ArrayCodec<T>;
    Hdf5Array<typename Codec::Scalar> array;
    array.dims.resize(take_count(sizeof(std::uint64_t)));
    std::size_t count = 1;
    for (std::size_t& dim : array.dims) {
      dim = take();
      if (dim != 0 && count > bytes_.size() / dim) fail_damaged();
      count *= dim;
    }
    const Hdf5Shape shape = Codec::shape();
    if (!std::equal(
            array.dims.begin(), array.dims.end(), shape.begin(), shape.end(),
            [](std::size_t is, std::size_t asked) { return asked == kAnyLength || asked == is; }))
      fail_damaged();
    array.values.resize(count);
    take_raw(array.values.data(), count * sizeof(array.values[0]));
    Codec::decode(array, values);
  }
  /// Reads a dataset if it is present.
  template <class T>
  void dataset_if(bool, const char* name, T& values, const DatasetAttributes& tags) {
    if (next_is(name)) dataset(name, values, tags);
  }
  /// Reads a dataset of names.
  void names(const char* name, std::vector<std::string>& values) { attribute(name, values); }
  /// Reads names if they are present.
  void optional_names(const char* name, std::vector<std::string>& values) {
    optional_attribute(name, values);
  }
  /// Reads one member of all rows.
  template <class Row, class Member>
  void column(const char* name, std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes&) {
    expect(name);
    rows.resize(take_count(1));
    for (Row& row : rows) take_item(row.*member);
  }
  /// Reads one member of all rows if it is present.
  template <class Row, class Member>
  void column_if(bool, const char* name, std::vector<Row>& rows, Member Row::*member,
                 const DatasetAttributes& tags) {
    if (next_is(name)) column(name, rows, member, tags);
  }
  /// Reads an attribute.
  template <class T>
  void attribute(const char* name, T& value) {
    expect(name);
    take_item(value);
  }
  /// Reads a flag, which is stored only if it is true.
  void optional_flag(const char* name, bool& value) { optional_attribute(name, value); }
  /// Reads an optional attribute.
  template <class T>
  void optional_attribute(const char* name, T& value) {
    if (next_is(name)) attribute(name, value);
  }
  /// Reads an optional attribute.
  template <class T>
  void optional_attribute(const char* name, std::optional<T>& value) {
    if (next_is(name)) attribute(name, value.emplace());
  }
  /// Reads a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    expect(name);
    body(*this);
  }
  /// Reads a group if it is present.
  template <class Body>
  void group_if(bool, const char* name, const Body& body) {
    if (next_is(name)) group(name, body);
  }
  /// Reads one group for each item.
  template <class Item, class Body>
  void each(std::vector<Item>& items, const Body& body) {
    items.resize(take_count(1));
    for (Item& item : items) {
      take_item(item.name);
      body(*this, item);
    }
  }

 private:
  [[noreturn]] static void fail_damaged() { throw InputError("is damaged"); }
  void take_raw(void* out, std::size_t count) {
    if (count > bytes_.size()) fail_damaged();
    if (count > 0) std::memcpy(out, bytes_.data(), count);
    bytes_.remove_prefix(count);
  }
  std::uint64_t take() {
    std::uint64_t number = 0;
    take_raw(&number, sizeof number);
    return number;
  }
  /// Reads a count of items that take at least `bytes_each` bytes each.
  std::size_t take_count(std::size_t bytes_each) {
    const std::uint64_t count = take();
    if (count > bytes_.size() / bytes_each) fail_damaged();
    return count;
  }
  std::string take_text() {
    std::string text(take_count(1), '\0');
    take_raw(text.data(), text.size());
    return text;
  }
  bool next_is(std::string_view name) {
    const std::string_view before = bytes_;
    if (at_end()) return false;
    const bool same = take_text() == name;
    bytes_ = before;
    return same;
  }
  void expect(std::string_view name) {
    if (take_text() != name) fail_damaged();
  }
  template <class T>
  void take_item(T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      value = take_text();
    } else if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t number = 0;
      take_item(number);
      value = number != 0;
    } else if constexpr (NamedEnum<T>) {
      const std::optional<T> known = enum_from_name<T>(take_text());
      if (!known) fail_damaged();
      value = *known;
    } else {
      using Codec = ItemCodec<T>;
      typename Codec::Scalar scalars[Codec::size];
      take_raw(scalars, sizeof scalars);
      Codec::decode(scalars, value);
    }
  }
  template <class T>
  void take_item(std::vector<T>& values) {
    values.resize(take_count(1));
    for (T& value : values) take_item(value);
  }

  std::string_view bytes_;
};

}  // namespace morphe::store
