#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "core/store/array_codec.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::store {

/// The attributes of a dataset.
struct DatasetAttributes {
  std::string unit;     ///< "m", "rad", "1" if dimensionless, "" for names, kJointUnit…
  std::string frame;    ///< of a pose or point, else ""
  std::string meaning;  ///< of a coded number: "0=rest,1=reach,…"
};

/// Placeholder for the unit of joint positions in DatasetAttributes: "rad", or "rad or m" for a
/// robot with prismatic joints.
inline constexpr std::string_view kJointUnit = "joint";
/// Returns the attributes of joint values, or of their derivatives ("/s", "/s^2").
inline DatasetAttributes joint_attributes(const std::string& per = "") {
  return {std::string(kJointUnit) + per, "", ""};
}
/// Returns the unit of a robot's joint positions.
inline std::string joint_unit(bool some_slide) { return some_slide ? "rad or m" : "rad"; }

/// Returns the meaning "0=rest,1=reach,…" of an enumeration.
template <NamedEnum E>
std::string meaning() {
  std::string text;
  for (std::size_t i = 0; i < enum_count<E>(); ++i)
    text += fmt::format("{}{}={}", i > 0 ? "," : "", i, name_of(static_cast<E>(i)));
  return text;
}

/// The type of a row's member in a column: bool becomes a byte, an enumeration its name.
template <class Member>
struct ColumnItem : std::type_identity<Member> {};
template <>
struct ColumnItem<bool> : std::type_identity<std::uint8_t> {};
template <NamedEnum E>
struct ColumnItem<E> : std::type_identity<std::string> {};

/// Writes a layout. A layout is defined once, as a function template over LayoutWriter or
/// LayoutReader and a struct (const for writing): the reader restores the written values bit for
/// bit.
class LayoutWriter {
 public:
  static constexpr bool reading = false;
  explicit LayoutWriter(Hdf5Group group, std::string joint = joint_unit(false))
      : group_(std::move(group)), joint_(std::move(joint)) {}
  /// Returns the current group.
  const Hdf5Group& current_group() const { return group_; }

  /// Writes a dataset.
  template <class T>
  void dataset(const char* name, const T& values, const DatasetAttributes& tags) {
    group_.write(name, ArrayCodec<T>::encode(values));
    tag(name, tags);
  }
  /// Writes a dataset if `present` is true.
  template <class T>
  void dataset_if(bool present, const char* name, const T& values, const DatasetAttributes& tags) {
    if (present) dataset(name, values, tags);
  }
  /// Writes a dataset of names.
  void names(const char* name, const std::vector<std::string>& values) {
    group_.write_strings(name, values);
    tag(name, {});
  }
  /// Writes names unless there are no names.
  void optional_names(const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) names(name, values);
  }
  /// Writes one member of a vector of rows as a dataset.
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes& tags) {
    using Item = typename ColumnItem<Member>::type;
    std::vector<Item> values;
    values.reserve(rows.size());
    for (const Row& row : rows) {
      if constexpr (NamedEnum<Member>) {
        values.emplace_back(name_of(row.*member));
      } else {
        values.push_back(row.*member);
      }
    }
    if constexpr (std::is_same_v<Item, std::string>) {
      names(name, values);
    } else {
      dataset(name, values, tags);
    }
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
    group_.set(name, value);
  }
  /// Writes an attribute.
  void attribute(const char* name, bool value) { group_.set(name, std::uint8_t{value}); }
  /// Writes an attribute.
  void attribute(const char* name, const Vec3& value) {
    group_.set(name, std::vector<double>{value.x(), value.y(), value.z()});
  }
  /// Writes an attribute that is omitted if it is false.
  void optional_flag(const char* name, bool value) {
    if (value) attribute(name, value);
  }
  /// Writes an optional attribute.
  void optional_attribute(const char* name, const std::string& value) { group_.set(name, value); }
  /// Writes an optional attribute.
  void optional_attribute(const char* name, double value) { group_.set(name, value); }
  /// Writes an optional attribute.
  template <class T>
  void optional_attribute(const char* name, const std::optional<T>& value) {
    if (value) attribute(name, *value);
  }
  /// Writes an attribute.
  template <NamedEnum E>
  void attribute(const char* name, const E& value) {
    group_.set(name, std::string(name_of(value)));
  }
  /// Writes an optional attribute.
  template <NamedEnum E>
  void optional_attribute(const char* name, const E& value) {
    attribute(name, value);
  }
  /// Writes a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    LayoutWriter inner(group_.create(name), joint_);
    body(inner);
  }
  /// Writes a group if `present` is true.
  template <class Body>
  void group_if(bool present, const char* name, const Body& body) {
    if (present) group(name, body);
  }
  /// Writes one group for each item, in order, under the item's name.
  template <class Item, class Body>
  void each(const std::vector<Item>& items, const Body& body) {
    for (const Item& item : items)
      group(item.name, [&](LayoutWriter& inner) { body(inner, item); });
  }

 private:
  void tag(const char* name, const DatasetAttributes& tags) {
    const bool of_joint = tags.unit.starts_with(kJointUnit);
    group_.set("unit", of_joint ? joint_ + tags.unit.substr(kJointUnit.size()) : tags.unit, name);
    if (!tags.frame.empty()) group_.set("frame", tags.frame, name);
    if (!tags.meaning.empty()) group_.set("meaning", tags.meaning, name);
  }

  Hdf5Group group_;
  std::string joint_;
};

/// Reads a layout.
class LayoutReader {
 public:
  static constexpr bool reading = true;
  explicit LayoutReader(Hdf5Group group) : group_(std::move(group)) {}
  /// Returns the current group.
  const Hdf5Group& current_group() const { return group_; }

  /// Reads a dataset.
  template <class T>
  void dataset(const char* name, T& values, const DatasetAttributes&) {
    using Codec = ArrayCodec<T>;
    Codec::decode(group_.read<typename Codec::Scalar>(name, Codec::shape()), values);
  }
  /// Reads a dataset if it is present.
  template <class T>
  void dataset_if(bool, const char* name, T& values, const DatasetAttributes& tags) {
    if (group_.has(name)) dataset(name, values, tags);
  }
  /// Reads a dataset of names.
  void names(const char* name, std::vector<std::string>& values) {
    values = group_.read_strings(name);
  }
  /// Reads names if they are present.
  void optional_names(const char* name, std::vector<std::string>& values) {
    if (group_.has(name)) names(name, values);
  }
  /// Reads one member of all rows. The first column that is read sets the number of rows.
  template <class Row, class Member>
  void column(const char* name, std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes& tags) {
    using Item = typename ColumnItem<Member>::type;
    std::vector<Item> values;
    if constexpr (std::is_same_v<Item, std::string>) {
      names(name, values);
    } else {
      dataset(name, values, tags);
    }
    if (!rows_known_) rows.resize(values.size());
    rows_known_ = true;
    if (rows.size() != values.size())
      group_.fail(name, fmt::format("has {} rows, not {}", values.size(), rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if constexpr (NamedEnum<Member>) {
        const std::optional<Member> value = enum_from_name<Member>(values[i]);
        if (!value) group_.fail(name, fmt::format("has the unknown value '{}'", values[i]));
        rows[i].*member = *value;
      } else {
        rows[i].*member = static_cast<Member>(std::move(values[i]));
      }
    }
  }
  /// Reads one member of all rows if it is present.
  template <class Row, class Member>
  void column_if(bool, const char* name, std::vector<Row>& rows, Member Row::*member,
                 const DatasetAttributes& tags) {
    if (group_.has(name)) column(name, rows, member, tags);
  }
  /// Reads an attribute.
  template <class T>
  void attribute(const char* name, T& value) {
    group_.get(name, value);
  }
  /// Reads an attribute.
  void attribute(const char* name, bool& value) {
    std::uint8_t number = 0;
    group_.get(name, number);
    value = number != 0;
  }
  /// Reads an attribute.
  void attribute(const char* name, Vec3& value) {
    std::vector<double> values;
    group_.get(name, values);
    if (values.size() != 3) group_.fail(fmt::format("@{} must have 3 numbers", name));
    ItemCodec<Vec3>::decode(values.data(), value);
  }
  /// Reads a flag, which is stored only if it is true.
  void optional_flag(const char* name, bool& value) {
    if (group_.has_attribute(name)) attribute(name, value);
  }
  /// Reads an optional attribute.
  void optional_attribute(const char* name, std::string& value) {
    if (group_.has_attribute(name)) group_.get(name, value);
  }
  /// Reads an optional attribute.
  void optional_attribute(const char* name, double& value) {
    if (group_.has_attribute(name)) group_.get(name, value);
  }
  /// Reads an optional attribute.
  template <class T>
  void optional_attribute(const char* name, std::optional<T>& value) {
    if (group_.has_attribute(name)) attribute(name, value.emplace());
  }
  /// Reads an attribute.
  template <NamedEnum E>
  void attribute(const char* name, E& value) {
    std::string text;
    group_.get(name, text);
    const std::optional<E> known = enum_from_name<E>(text);
    if (!known) group_.fail(fmt::format("@{} has the unknown value '{}'", name, text));
    value = *known;
  }
  /// Reads an optional attribute.
  template <NamedEnum E>
  void optional_attribute(const char* name, E& value) {
    if (group_.has_attribute(name)) attribute(name, value);
  }
  /// Reads a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    LayoutReader inner(group_.open(name));
    body(inner);
  }
  /// Reads a group if it is present.
  template <class Body>
  void group_if(bool, const char* name, const Body& body) {
    if (group_.has(name)) group(name, body);
  }
  /// Reads one group for each item.
  template <class Item, class Body>
  void each(std::vector<Item>& items, const Body& body) {
    for (const std::string& name : group_.children()) {
      Item& item = items.emplace_back();
      item.name = name;
      group(name, [&](LayoutReader& inner) { body(inner, item); });
    }
  }

 private:
  Hdf5Group group_;
  bool rows_known_ = false;
};

}  // namespace morphe::store
