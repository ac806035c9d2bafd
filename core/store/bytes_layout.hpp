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

/// The layouts of the files (layout.hpp) over plain bytes instead of HDF5: what a file would hold,
/// for hashing and for the journal of a run. The same values give the same bytes. Every item is
/// preceded by its name; numbers are little-endian as in memory. Bytes that do not hold what is
/// asked for throw InputError.
struct BytesPlace {
  [[noreturn]] void fail(const std::string& message) const { throw InputError(message); }
};

class BytesWriter {
 public:
  static constexpr bool reading = false;
  explicit BytesWriter(std::string& bytes) : bytes_(bytes) {}
  BytesPlace here() const { return {}; }

  template <class T>
  void dataset(const char* name, const T& values, const Tags&) {
    begin(name);
    const auto array = ArrayCodec<T>::encode(values);
    put(array.dims.size());
    for (const std::size_t dim : array.dims) put(dim);
    put_raw(array.values.data(), array.values.size() * sizeof(array.values[0]));
  }
  template <class T>
  void dataset_if(bool present, const char* name, const T& values, const Tags& tags) {
    if (present) dataset(name, values, tags);
  }
  void names(const char* name, const std::vector<std::string>& values) { attribute(name, values); }
  void names_if_any(const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) names(name, values);
  }
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member, const Tags&) {
    begin(name);
    put(rows.size());
    for (const Row& row : rows) put_item(row.*member);
  }
  template <class Row, class Member>
  void column_if(bool present, const char* name, const std::vector<Row>& rows, Member Row::*member,
                 const Tags& tags) {
    if (present) column(name, rows, member, tags);
  }
  template <class T>
  void attribute(const char* name, const T& value) {
    begin(name);
    put_item(value);
  }
  void maybe_true(const char* name, bool value) {
    if (value) attribute(name, value);
  }
  template <class T>
  void maybe(const char* name, const T& value) {
    attribute(name, value);
  }
  template <class T>
  void maybe(const char* name, const std::optional<T>& value) {
    if (value) attribute(name, *value);
  }
  template <class Body>
  void group(const std::string& name, const Body& body) {
    begin(name);
    body(*this);
  }
  template <class Body>
  void group_if(bool present, const char* name, const Body& body) {
    if (present) group(name, body);
  }
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
    } else if constexpr (Named<T>) {
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

class BytesReader {
 public:
  static constexpr bool reading = true;
  explicit BytesReader(std::string_view bytes) : bytes_(bytes) {}
  BytesPlace here() const { return {}; }
  bool at_end() const { return bytes_.empty(); }

  template <class T>
  void dataset(const char* name, T& values, const Tags&) {
    expect(name);
    using Codec = ArrayCodec<T>;
    Hdf5Array<typename Codec::Scalar> array;
    array.dims.resize(take_count(sizeof(std::uint64_t)));
    std::size_t count = 1;
    for (std::size_t& dim : array.dims) {
      dim = take();
      if (dim != 0 && count > bytes_.size() / dim) damaged();
      count *= dim;
    }
    const Hdf5Shape shape = Codec::shape();
    if (!std::equal(
            array.dims.begin(), array.dims.end(), shape.begin(), shape.end(),
            [](std::size_t is, std::size_t asked) { return asked == kAnyLength || asked == is; }))
      damaged();
    array.values.resize(count);
    take_raw(array.values.data(), count * sizeof(array.values[0]));
    Codec::decode(array, values);
  }
  template <class T>
  void dataset_if(bool, const char* name, T& values, const Tags& tags) {
    if (comes(name)) dataset(name, values, tags);
  }
  void names(const char* name, std::vector<std::string>& values) { attribute(name, values); }
  void names_if_any(const char* name, std::vector<std::string>& values) { maybe(name, values); }
  template <class Row, class Member>
  void column(const char* name, std::vector<Row>& rows, Member Row::*member, const Tags&) {
    expect(name);
    rows.resize(take_count(1));
    for (Row& row : rows) take_item(row.*member);
  }
  template <class Row, class Member>
  void column_if(bool, const char* name, std::vector<Row>& rows, Member Row::*member,
                 const Tags& tags) {
    if (comes(name)) column(name, rows, member, tags);
  }
  template <class T>
  void attribute(const char* name, T& value) {
    expect(name);
    take_item(value);
  }
  void maybe_true(const char* name, bool& value) { maybe(name, value); }
  template <class T>
  void maybe(const char* name, T& value) {
    if (comes(name)) attribute(name, value);
  }
  template <class T>
  void maybe(const char* name, std::optional<T>& value) {
    if (comes(name)) attribute(name, value.emplace());
  }
  template <class Body>
  void group(const std::string& name, const Body& body) {
    expect(name);
    body(*this);
  }
  template <class Body>
  void group_if(bool, const char* name, const Body& body) {
    if (comes(name)) group(name, body);
  }
  template <class Item, class Body>
  void each(std::vector<Item>& items, const Body& body) {
    items.resize(take_count(1));
    for (Item& item : items) {
      take_item(item.name);
      body(*this, item);
    }
  }

 private:
  [[noreturn]] static void damaged() { throw InputError("is damaged"); }
  void take_raw(void* out, std::size_t count) {
    if (count > bytes_.size()) damaged();
    if (count > 0) std::memcpy(out, bytes_.data(), count);
    bytes_.remove_prefix(count);
  }
  std::uint64_t take() {
    std::uint64_t number = 0;
    take_raw(&number, sizeof number);
    return number;
  }
  /// A number of items that take at least `bytes_each` bytes.
  std::size_t take_count(std::size_t bytes_each) {
    const std::uint64_t count = take();
    if (count > bytes_.size() / bytes_each) damaged();
    return count;
  }
  std::string take_text() {
    std::string text(take_count(1), '\0');
    take_raw(text.data(), text.size());
    return text;
  }
  bool comes(std::string_view name) {
    const std::string_view before = bytes_;
    if (at_end()) return false;
    const bool same = take_text() == name;
    bytes_ = before;
    return same;
  }
  void expect(std::string_view name) {
    if (take_text() != name) damaged();
  }
  template <class T>
  void take_item(T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      value = take_text();
    } else if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t number = 0;
      take_item(number);
      value = number != 0;
    } else if constexpr (Named<T>) {
      const std::optional<T> known = named<T>(take_text());
      if (!known) damaged();
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
