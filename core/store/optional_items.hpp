#pragma once

#include <optional>
#include <string>
#include <vector>

namespace morphe::store {

/// The attributes of a dataset.
struct DatasetAttributes {
  std::string unit;     ///< "m", "rad", "1" if dimensionless, "" for names, kJointUnit…
  std::string frame;    ///< of a pose or point, else ""
  std::string meaning;  ///< of the numbers in codes: "0=rest,1=reach,…"
};

/// Writes items that may be absent, by means of `Io`, which derives from this and writes items.
template <class Io>
class OptionalItemWriter {
 public:
  static constexpr bool reading = false;
  /// Writes a dataset if `present` is true.
  template <class T>
  void dataset_if(bool present, const char* name, const T& values, const DatasetAttributes& tags) {
    if (present) io().dataset(name, values, tags);
  }
  /// Writes names unless there are no names.
  void optional_names(const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) io().names(name, values);
  }
  /// Writes one member of all rows if `present` is true.
  template <class Row, class Member>
  void column_if(bool present, const char* name, const std::vector<Row>& rows, Member Row::*member,
                 const DatasetAttributes& tags) {
    if (present) io().column(name, rows, member, tags);
  }
  /// Writes a flag, which is stored only if it is true.
  void optional_flag(const char* name, bool value) {
    if (value) io().attribute(name, value);
  }
  /// Writes an attribute; only other programs may omit it.
  template <class T>
  void optional_attribute(const char* name, const T& value) {
    io().attribute(name, value);
  }
  /// Writes an attribute unless it is absent.
  template <class T>
  void optional_attribute(const char* name, const std::optional<T>& value) {
    if (value) io().attribute(name, *value);
  }
  /// Writes a group if `present` is true.
  template <class Body>
  void group_if(bool present, const char* name, const Body& body) {
    if (present) io().group(name, body);
  }

 private:
  Io& io() { return static_cast<Io&>(*this); }
};

/// Reads items that may be absent, by means of `Io`, which derives from this and reads items.
/// Values of absent items are left as they are.
template <class Io>
class OptionalItemReader {
 public:
  static constexpr bool reading = true;
  /// Reads a dataset if it is present.
  template <class T>
  void dataset_if(bool, const char* name, T& values, const DatasetAttributes& tags) {
    if (io().has_item(name)) io().dataset(name, values, tags);
  }
  /// Reads names if they are present.
  void optional_names(const char* name, std::vector<std::string>& values) {
    if (io().has_item(name)) io().names(name, values);
  }
  /// Reads one member of all rows if it is present.
  template <class Row, class Member>
  void column_if(bool, const char* name, std::vector<Row>& rows, Member Row::*member,
                 const DatasetAttributes& tags) {
    if (io().has_item(name)) io().column(name, rows, member, tags);
  }
  /// Reads a flag, which is stored only if it is true.
  void optional_flag(const char* name, bool& value) { optional_attribute(name, value); }
  /// Reads an attribute if it is present.
  template <class T>
  void optional_attribute(const char* name, T& value) {
    if (io().has_attribute(name)) io().attribute(name, value);
  }
  /// Reads an attribute if it is present.
  template <class T>
  void optional_attribute(const char* name, std::optional<T>& value) {
    if (io().has_attribute(name)) io().attribute(name, value.emplace());
  }
  /// Reads a group if it is present.
  template <class Body>
  void group_if(bool, const char* name, const Body& body) {
    if (io().has_item(name)) io().group(name, body);
  }

 private:
  Io& io() { return static_cast<Io&>(*this); }
};

}  // namespace morphe::store
