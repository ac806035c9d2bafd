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

#include "core/motion/named.hpp"
#include "core/store/array_codec.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::store {

/// Attributes of a dataset.
struct Tags {
  std::string unit;     ///< "m", "rad", "1" for a number without one, "" for names, kJoint…
  std::string frame;    ///< of a pose or point, else ""
  std::string meaning;  ///< of a coded number: "0=rest,1=reach,…"
};

/// Stands for the unit of joint positions in Tags: "rad", or "rad or m" of a robot some of whose
/// joints slide.
inline constexpr std::string_view kJoint = "joint";
inline Tags of_joints(const std::string& per = "") { return {std::string(kJoint) + per, "", ""}; }
inline std::string joint_unit(bool some_slide) { return some_slide ? "rad or m" : "rad"; }

/// "0=rest,1=reach,…" of an enumeration.
template <Named E>
std::string meaning() {
  std::string text;
  for (std::size_t i = 0; i < count_of<E>(); ++i)
    text += fmt::format("{}{}={}", i > 0 ? "," : "", i, name_of(static_cast<E>(i)));
  return text;
}

/// How a row's member stands in a column: truth as a byte, an enumeration by its names.
template <class Member>
struct ColumnItem : std::type_identity<Member> {};
template <>
struct ColumnItem<bool> : std::type_identity<std::uint8_t> {};
template <Named E>
struct ColumnItem<E> : std::type_identity<std::string> {};

/// A layout is written once, as a function template over these two classes and over a struct
/// (const for writing): what one writes, the other takes back bit for bit.
class LayoutWriter {
 public:
  static constexpr bool reading = false;
  explicit LayoutWriter(Hdf5Group group, std::string joint = joint_unit(false))
      : group_(std::move(group)), joint_(std::move(joint)) {}
  const Hdf5Group& here() const { return group_; }

  template <class T>
  void dataset(const char* name, const T& values, const Tags& tags) {
    group_.write(name, ArrayCodec<T>::encode(values));
    tag(name, tags);
  }
  template <class T>
  void dataset_if(bool present, const char* name, const T& values, const Tags& tags) {
    if (present) dataset(name, values, tags);
  }
  void names(const char* name, const std::vector<std::string>& values) {
    group_.write_strings(name, values);
    tag(name, {});
  }
  void names_if_any(const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) names(name, values);
  }
  /// One member of a vector of rows, as a dataset of its own.
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member,
              const Tags& tags) {
    using Item = typename ColumnItem<Member>::type;
    std::vector<Item> values;
    values.reserve(rows.size());
    for (const Row& row : rows) {
      if constexpr (Named<Member>) {
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
  template <class Row, class Member>
  void column_if(bool present, const char* name, const std::vector<Row>& rows, Member Row::*member,
                 const Tags& tags) {
    if (present) column(name, rows, member, tags);
  }
  template <class T>
  void attribute(const char* name, const T& value) {
    group_.set(name, value);
  }
  void attribute(const char* name, bool value) { group_.set(name, std::uint8_t{value}); }
  void attribute(const char* name, const Vec3& value) {
    group_.set(name, std::vector<double>{value.x(), value.y(), value.z()});
  }
  /// An attribute that is not there where it is false.
  void maybe_true(const char* name, bool value) {
    if (value) attribute(name, value);
  }
  void maybe(const char* name, const std::string& value) { group_.set(name, value); }
  void maybe(const char* name, double value) { group_.set(name, value); }
  template <class T>
  void maybe(const char* name, const std::optional<T>& value) {
    if (value) attribute(name, *value);
  }
  template <Named E>
  void attribute(const char* name, const E& value) {
    group_.set(name, std::string(name_of(value)));
  }
  template <Named E>
  void maybe(const char* name, const E& value) {
    attribute(name, value);
  }
  template <class Body>
  void group(const std::string& name, const Body& body) {
    LayoutWriter inner(group_.create(name), joint_);
    body(inner);
  }
  template <class Body>
  void group_if(bool present, const char* name, const Body& body) {
    if (present) group(name, body);
  }
  /// A group for each, in order, under its name.
  template <class Item, class Body>
  void each(const std::vector<Item>& items, const Body& body) {
    for (const Item& item : items)
      group(item.name, [&](LayoutWriter& inner) { body(inner, item); });
  }

 private:
  void tag(const char* name, const Tags& tags) {
    const bool of_joint = tags.unit.starts_with(kJoint);
    group_.set("unit", of_joint ? joint_ + tags.unit.substr(kJoint.size()) : tags.unit, name);
    if (!tags.frame.empty()) group_.set("frame", tags.frame, name);
    if (!tags.meaning.empty()) group_.set("meaning", tags.meaning, name);
  }

  Hdf5Group group_;
  std::string joint_;
};

class LayoutReader {
 public:
  static constexpr bool reading = true;
  explicit LayoutReader(Hdf5Group group) : group_(std::move(group)) {}
  const Hdf5Group& here() const { return group_; }

  template <class T>
  void dataset(const char* name, T& values, const Tags&) {
    using Codec = ArrayCodec<T>;
    Codec::decode(group_.read<typename Codec::Scalar>(name, Codec::shape()), values);
  }
  template <class T>
  void dataset_if(bool, const char* name, T& values, const Tags& tags) {
    if (group_.has(name)) dataset(name, values, tags);
  }
  void names(const char* name, std::vector<std::string>& values) {
    values = group_.read_strings(name);
  }
  void names_if_any(const char* name, std::vector<std::string>& values) {
    if (group_.has(name)) names(name, values);
  }
  /// The first column read decides how many rows there are.
  template <class Row, class Member>
  void column(const char* name, std::vector<Row>& rows, Member Row::*member, const Tags& tags) {
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
      if constexpr (Named<Member>) {
        const std::optional<Member> value = named<Member>(values[i]);
        if (!value) group_.fail(name, fmt::format("holds '{}', which is not known", values[i]));
        rows[i].*member = *value;
      } else {
        rows[i].*member = static_cast<Member>(std::move(values[i]));
      }
    }
  }
  template <class Row, class Member>
  void column_if(bool, const char* name, std::vector<Row>& rows, Member Row::*member,
                 const Tags& tags) {
    if (group_.has(name)) column(name, rows, member, tags);
  }
  template <class T>
  void attribute(const char* name, T& value) {
    group_.get(name, value);
  }
  void attribute(const char* name, bool& value) {
    std::uint8_t number = 0;
    group_.get(name, number);
    value = number != 0;
  }
  void attribute(const char* name, Vec3& value) {
    std::vector<double> values;
    group_.get(name, values);
    if (values.size() != 3) group_.fail(fmt::format("@{} does not hold 3 numbers", name));
    ItemCodec<Vec3>::decode(values.data(), value);
  }
  void maybe_true(const char* name, bool& value) {
    if (group_.has_attribute(name)) attribute(name, value);
  }
  void maybe(const char* name, std::string& value) {
    if (group_.has_attribute(name)) group_.get(name, value);
  }
  void maybe(const char* name, double& value) {
    if (group_.has_attribute(name)) group_.get(name, value);
  }
  template <class T>
  void maybe(const char* name, std::optional<T>& value) {
    if (group_.has_attribute(name)) attribute(name, value.emplace());
  }
  template <Named E>
  void attribute(const char* name, E& value) {
    std::string text;
    group_.get(name, text);
    const std::optional<E> known = named<E>(text);
    if (!known) group_.fail(fmt::format("@{} is '{}', which is not known", name, text));
    value = *known;
  }
  template <Named E>
  void maybe(const char* name, E& value) {
    if (group_.has_attribute(name)) attribute(name, value);
  }
  template <class Body>
  void group(const std::string& name, const Body& body) {
    LayoutReader inner(group_.open(name));
    body(inner);
  }
  template <class Body>
  void group_if(bool, const char* name, const Body& body) {
    if (group_.has(name)) group(name, body);
  }
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
