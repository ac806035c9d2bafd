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
/// its attributes and datasets are members. A group of columns is an array with one object per row.
/// Points are three numbers, poses four rows of four, enumerations their names. Numbers that are
/// not finite are null.
class JsonWriter : public OptionalItemWriter<JsonWriter> {
 public:
  using Json = nlohmann::ordered_json;
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
  /// Writes a dataset of names.
  void names(const char* name, const std::vector<std::string>& values) { json[name] = values; }
  /// Writes one member of all rows.
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member,
              const DatasetAttributes&) {
    if (!json.is_array()) json = Json::array();
    for (int k = 0; k < std::ssize(rows); ++k) json[k][name] = json_of(rows[k].*member);
  }
  /// Writes a group.
  template <class Body>
  void group(const char* name, const Body& body) {
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
      for (Eigen::Index k = 0; k < values.rows(); ++k) list.push_back(json_of(values.row(k)));
    }
    return list;
  }
  static Json json_of(const Pose& pose) { return json_of(pose.matrix()); }
};

}  // namespace morphe::store
