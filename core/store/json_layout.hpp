#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/named.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// The layouts of the files (layout.hpp) as JSON, for what others read: a group is an object, its
/// attributes and datasets are members, columns of rows are an array of objects. Points are three
/// numbers, poses four rows of four, enumerations their names; what is not finite is null.
class JsonWriter {
 public:
  using Json = nlohmann::ordered_json;
  static constexpr bool reading = false;
  Json json = Json::object();

  template <class T>
  void attribute(const char* name, const T& value) {
    json[name] = json_of(value);
  }
  template <class T>
  void dataset(const char* name, const T& value, const Tags&) {
    json[name] = json_of(value);
  }
  template <class T>
  void dataset_if(bool present, const char* name, const T& value, const Tags& tags) {
    if (present) dataset(name, value, tags);
  }
  void names(const char* name, const std::vector<std::string>& values) { json[name] = values; }
  void names_if_any(const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) names(name, values);
  }
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>& rows, Member Row::*member, const Tags&) {
    if (!json.is_array()) json = Json::array();
    for (std::size_t k = 0; k < rows.size(); ++k) json[k][name] = json_of(rows[k].*member);
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
  void group_if(bool present, const char* name, const Body& body) {
    if (!present) return;
    JsonWriter inner;
    body(inner);
    json[name] = std::move(inner.json);
  }

 private:
  static Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(); }
  template <Named E>
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
  /// A vector of numbers as a list, a matrix as its rows.
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
