#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/motion/enum_names.hpp"
#include "core/motion/geometry.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// Writes the layouts of the files (layout.hpp) as JSON for other programs: a group is an object,
/// its attributes and datasets are members, columns of rows are an array of objects. Points are
/// three numbers, poses four rows of four, enumerations their names; values that are not finite are
/// null.
class JsonWriter {
 public:
  using Json = nlohmann::ordered_json;
  static constexpr bool reading = false;
  Json json = Json::object();

  /// Writes an attribute.
  template <class T>
  void attribute(const char* name, const T& value) {
    json[name] = json_of(value);
  }
  /// Writes a dataset.
  template <class T>
  void dataset(const char* name, const T& value, const DatasetAttributes&) {
    json[name] = json_of(value);
  }
  /// Writes a dataset if `present` is true.
  template <class T>
  void dataset_if(bool present, const char* name, const T& value, const DatasetAttributes& tags) {
    if (present) dataset(name, value, tags);
  }
  /// Writes a dataset of names.
  void names(const char* name, const std::vector<std::string>& values) { json[name] = values; }
  /// Writes names unless there are no names.
  void optional_names(const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) names(name, values);
  }
  /// Writes one member of all rows.
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes&) {
    if (!json.is_array()) json = Json::array();
    for (std::size_t k = 0; k < rows.size(); ++k) json[k][name] = json_of(rows[k].*member);
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
  /// Writes a group if `present` is true.
  template <class Body>
  void group_if(bool present, const char* name, const Body& body) {
    if (!present) return;
    JsonWriter inner;
    body(inner);
    json[name] = std::move(inner.json);
  }

 private:
  static Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(); }
  template <NamedEnum E>
  static Json json_of(E value) {
    return name_of(value);
  }
  template <class T>
  requires(std::is_integral_v<T> || std::is_convertible_v<T, std::string>) static Json
      json_of(const T& value) {
    return value;
  }
  template <class T>
  static Json json_of(const std::vector<T>& values) {
    Json list = Json::array();
    for (const T& value : values) list.push_back(json_of(value));
    return list;
  }
  /// Returns a vector of numbers as a list, a matrix as a list of its rows.
  template <class Derived>
  static Json json_of(const Eigen::DenseBase<Derived>& values) {
    Json list = Json::array();
    if constexpr (Derived::IsVectorAtCompileTime) {
      for (Eigen::Index k = 0; k < values.size(); ++k) list.push_back(json_of(values(k)));
    } else {
      for (Eigen::Index row = 0; row < values.rows(); ++row)
        list.push_back(json_of(values.row(row)));
    }
    return list;
  }
  static Json json_of(const Pose& pose) { return json_of(pose.matrix()); }
};

}  // namespace morphe::store
