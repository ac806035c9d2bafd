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
#include "core/store/optional_items.hpp"

namespace morphe::store {

/// Placeholder for the unit of joint positions in DatasetAttributes: "rad", or "rad or m" for a
/// robot with prismatic joints.
inline constexpr std::string_view kJointUnit = "joint";
/// Returns the attributes of joint values, or of their derivatives ("/s", "/s^2").
inline DatasetAttributes joint_attributes(const std::string& per = "") {
  return {std::string(kJointUnit) + per, "", ""};
}
/// Returns the unit of the joint positions of a robot, with prismatic joints or without.
inline std::string joint_unit(bool prismatic) { return prismatic ? "rad or m" : "rad"; }

/// Returns a unit with `joint_unit` in the place of kJointUnit.
inline std::string with_joint_unit(std::string unit, const std::string& joint_unit) {
  if (unit.starts_with(kJointUnit)) unit.replace(0, kJointUnit.size(), joint_unit);
  return unit;
}

/// Returns the numbers and names of an enumeration: "0=rest,1=reach,…".
template <NamedEnum E>
std::string meaning() {
  std::string text;
  for (std::size_t i = 0; i < enum_count<E>(); ++i)
    text += fmt::format("{}{}={}", i > 0 ? "," : "", i, name_of(static_cast<E>(i)));
  return text;
}

/// The type in a column of a row's member: bool becomes a byte, an enumeration its name.
template <class Member>
struct ColumnItem : std::type_identity<Member> {};
template <>
struct ColumnItem<bool> : std::type_identity<std::uint8_t> {};
template <NamedEnum E>
struct ColumnItem<E> : std::type_identity<std::string> {};

/// Writes a layout to an HDF5 group. A layout is a function template, defined once, of a writer or
/// reader `io` and a struct (const for writing), so that LayoutReader restores the values bit for
/// bit. Other writers and readers are in bytes_layout.hpp and json_layout.hpp.
class LayoutWriter : public OptionalItemWriter<LayoutWriter> {
 public:
  explicit LayoutWriter(Hdf5Group group, std::string unit = joint_unit(false))
      : group_(std::move(group)), joint_unit_(std::move(unit)) {}
  /// Returns the current group.
  const Hdf5Group& current_group() const { return group_; }

  /// Writes a dataset.
  template <class T>
  void dataset(const char* name, const T& values, const DatasetAttributes& tags) {
    group_.write(name, ArrayCodec<T>::encode(values));
    tag(name, tags);
  }
  /// Writes a dataset of names.
  void names(const char* name, const std::vector<std::string>& values) {
    group_.write_strings(name, values);
    tag(name, {});
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
  /// Writes an attribute.
  template <class T>
  void attribute(const char* name, const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      group_.set(name, std::uint8_t{value});
    } else if constexpr (std::is_same_v<T, Vec3>) {
      group_.set(name, std::vector<double>(value.begin(), value.end()));
    } else if constexpr (NamedEnum<T>) {
      group_.set(name, std::string(name_of(value)));
    } else {
      group_.set(name, value);
    }
  }
  /// Writes a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    LayoutWriter inner(group_.create(name), joint_unit_);
    body(inner);
  }
  /// Writes one group for each item, in order, under the item's name.
  template <class Item, class Body>
  void each(const std::vector<Item>& items, const Body& body) {
    for (const Item& item : items)
      group(item.name, [&](LayoutWriter& inner) { body(inner, item); });
  }

 private:
  void tag(const char* name, const DatasetAttributes& tags) {
    group_.set("unit", with_joint_unit(tags.unit, joint_unit_), name);
    if (!tags.frame.empty()) group_.set("frame", tags.frame, name);
    if (!tags.meaning.empty()) group_.set("meaning", tags.meaning, name);
  }

  Hdf5Group group_;
  std::string joint_unit_;
};

/// Reads a layout from an HDF5 group.
class LayoutReader : public OptionalItemReader<LayoutReader> {
 public:
  explicit LayoutReader(Hdf5Group group) : group_(std::move(group)) {}
  /// Returns the current group.
  const Hdf5Group& current_group() const { return group_; }
  /// Returns true if the group has a dataset or a group of this name.
  bool has_item(const char* name) const { return group_.has(name); }
  /// Returns true if the group has the attribute.
  bool has_attribute(const char* name) const { return group_.has_attribute(name); }

  /// Reads a dataset.
  template <class T>
  void dataset(const char* name, T& values, const DatasetAttributes&) {
    using Codec = ArrayCodec<T>;
    Codec::decode(group_.read<typename Codec::Scalar>(name, Codec::shape()), values);
  }
  /// Reads a dataset of names.
  void names(const char* name, std::vector<std::string>& values) {
    values = group_.read_strings(name);
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
    for (int i = 0; i < std::ssize(rows); ++i) {
      if constexpr (NamedEnum<Member>) {
        const std::optional<Member> value = enum_from_name<Member>(values[i]);
        if (!value) group_.fail(name, fmt::format("has the unknown value '{}'", values[i]));
        rows[i].*member = *value;
      } else {
        rows[i].*member = static_cast<Member>(std::move(values[i]));
      }
    }
  }
  /// Reads an attribute.
  template <class T>
  void attribute(const char* name, T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t number = 0;
      group_.get(name, number);
      value = number != 0;
    } else if constexpr (std::is_same_v<T, Vec3>) {
      std::vector<double> values;
      group_.get(name, values);
      if (values.size() != 3) group_.fail(fmt::format("@{} must have 3 numbers", name));
      ItemCodec<Vec3>::decode(values.data(), value);
    } else if constexpr (NamedEnum<T>) {
      std::string text;
      group_.get(name, text);
      const std::optional<T> known = enum_from_name<T>(text);
      if (!known) group_.fail(fmt::format("@{} has the unknown value '{}'", name, text));
      value = *known;
    } else {
      group_.get(name, value);
    }
  }
  /// Reads a group.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    LayoutReader inner(group_.open(name));
    body(inner);
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
