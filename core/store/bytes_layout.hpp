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

/// Stands for the current group, for layouts that report an error in it: throws InputError.
struct BytesPlace {
  [[noreturn]] void fail(const std::string& message) const { throw InputError(message); }
};

/// Appends the items of a file's layout (layout.hpp) to a byte string instead of an HDF5 file, for
/// hashing and for the journal of a run. Equal values give equal bytes. Every item is preceded by
/// its name, every array and text by its size. Numbers are as in memory, that is, little-endian.
class BytesWriter : public OptionalItemWriter<BytesWriter> {
 public:
  explicit BytesWriter(std::string& bytes) : bytes_(bytes) {}
  /// Returns an object that reports errors.
  BytesPlace current_group() const { return {}; }

  /// Writes a dataset.
  template <class T>
  void dataset(const char* name, const T& values, const DatasetAttributes&) {
    put_name(name);
    const auto array = ArrayCodec<T>::encode(values);
    put_number(array.dims.size());
    for (const std::size_t dim : array.dims) put_number(dim);
    put_raw(array.values.data(), array.values.size() * sizeof(array.values[0]));
  }
  /// Writes a dataset of names.
  void names(const char* name, const std::vector<std::string>& values) { attribute(name, values); }
  /// Writes one member of all rows.
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes&) {
    put_name(name);
    put_number(rows.size());
    for (const Row& row : rows) put_item(row.*member);
  }
  /// Writes an attribute.
  template <class T>
  void attribute(const char* name, const T& value) {
    put_name(name);
    put_item(value);
  }
  /// Writes a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    put_name(name);
    body(*this);
  }
  /// Writes one group for each item.
  template <class Item, class Body>
  void each(const std::vector<Item>& items, const Body& body) {
    put_number(items.size());
    for (const Item& item : items) group(item.name, [&](BytesWriter& in) { body(in, item); });
  }

 private:
  void put_name(std::string_view name) { put_text(name); }
  void put_number(std::uint64_t number) { put_raw(&number, sizeof number); }
  void put_raw(const void* data, std::size_t size) {
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }
  void put_text(std::string_view text) {
    put_number(text.size());
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
    put_number(values.size());
    for (const T& value : values) put_item(value);
  }

  std::string& bytes_;
};

/// Reads the items of a layout from a byte string; throws InputError if the bytes do not fit it.
class BytesReader : public OptionalItemReader<BytesReader> {
 public:
  explicit BytesReader(std::string_view bytes) : bytes_(bytes) {}
  /// Returns an object that reports errors.
  BytesPlace current_group() const { return {}; }
  bool at_end() const { return bytes_.empty(); }
  /// Throws InputError unless all bytes were read.
  void expect_end() const {
    if (!at_end()) fail_damaged();
  }
  /// Returns true if the next item has this name.
  bool has_item(std::string_view name) {
    if (at_end()) return false;
    const std::string_view rest = bytes_;
    const bool same = take_text() == name;
    bytes_ = rest;
    return same;
  }
  /// Returns true if the next item has this name.
  bool has_attribute(std::string_view name) { return has_item(name); }

  /// Reads a dataset.
  template <class T>
  void dataset(const char* name, T& values, const DatasetAttributes&) {
    expect(name);
    using Codec = ArrayCodec<T>;
    Hdf5Array<typename Codec::Scalar> array;
    array.dims.resize(take_count(sizeof(std::uint64_t)));
    std::size_t count = 1;
    for (std::size_t& dim : array.dims) {
      dim = take_number();
      if (dim != 0 && count > bytes_.size() / dim) fail_damaged();
      count *= dim;
    }
    if (!has_shape(array.dims, Codec::shape())) fail_damaged();
    array.values.resize(count);
    take_raw(array.values.data(), count * sizeof(array.values[0]));
    Codec::decode(array, values);
  }
  /// Reads a dataset of names.
  void names(const char* name, std::vector<std::string>& values) { attribute(name, values); }
  /// Reads one member of all rows.
  template <class Row, class Member>
  void column(const char* name, std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes&) {
    expect(name);
    rows.resize(take_count(1));
    for (Row& row : rows) take_item(row.*member);
  }
  /// Reads an attribute.
  template <class T>
  void attribute(const char* name, T& value) {
    expect(name);
    take_item(value);
  }
  /// Reads a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    expect(name);
    body(*this);
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
  void take_raw(void* out, std::size_t size) {
    if (size > bytes_.size()) fail_damaged();
    if (size > 0) std::memcpy(out, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }
  std::uint64_t take_number() {
    std::uint64_t number = 0;
    take_raw(&number, sizeof number);
    return number;
  }
  /// Reads a count of items; fails if the rest is too short for `bytes_each` bytes of each item.
  std::size_t take_count(std::size_t bytes_each) {
    const std::uint64_t count = take_number();
    if (count > bytes_.size() / bytes_each) fail_damaged();
    return count;
  }
  std::string take_text() {
    std::string text(take_count(1), '\0');
    take_raw(text.data(), text.size());
    return text;
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
