#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/store/layout.hpp"

namespace morphe::store {

/// Compares a group of a file with what LayoutWriter would write there, by the same layouts: the
/// names and types of all members and attributes, and unit, frame and meaning of datasets. The
/// values are not compared: lay out what was read from the group. Faults are sentences that begin
/// with the path below the first group: "trajectory/position_corrected is not part of the format".
class LayoutContract : public OptionalItemWriter<LayoutContract> {
 public:
  /// Compares `group`; `path` is "" or ends in '/'.
  LayoutContract(Hdf5Group group, std::string path, std::string joint_unit,
                 std::vector<std::string>& faults)
      : group_(std::move(group)),
        path_(std::move(path)),
        joint_unit_(std::move(joint_unit)),
        faults_(faults) {}
  /// Returns the current group.
  const Hdf5Group& current_group() const { return group_; }

  /// Compares a dataset.
  template <class T>
  void dataset(const char* name, const T&, const DatasetAttributes& tags) {
    expect_dataset(name, type_name<typename ArrayCodec<T>::Scalar>(), tags);
  }
  /// Compares a dataset of names.
  void names(const char* name, const std::vector<std::string>&) {
    expect_dataset(name, type_name<std::string>(), {});
  }
  /// Compares the dataset of one member of all rows.
  template <class Row, class Member>
  void column(const char* name, const std::vector<Row>&, Member Row::*,
              const DatasetAttributes& tags) {
    using Item = typename ColumnItem<Member>::type;
    if constexpr (std::is_same_v<Item, std::string>) {
      expect_dataset(name, type_name<std::string>(), {});
    } else {
      dataset(name, std::vector<Item>(), tags);
    }
  }
  /// Compares an attribute.
  template <class T>
  void attribute(const char* name, const T&) {
    using Item = typename ColumnItem<T>::type;
    if constexpr (std::is_same_v<Item, std::string> || std::is_integral_v<Item> ||
                  std::is_same_v<Item, double>) {
      expect_attribute(name, type_name<Item>());
    } else if constexpr (std::is_same_v<Item, std::vector<std::string>>) {
      expect_attribute(name, type_name<std::string>());
    } else {
      expect_attribute(name, type_name<double>());
    }
  }
  /// Compares a group with all that is in it.
  template <class Body>
  void group(const std::string& name, const Body& body) {
    if (!expect_member(name, true)) return;
    LayoutContract inner(group_.open(name), path_ + name + "/", joint_unit_, faults_);
    body(inner);
    inner.finish();
  }
  /// Compares one group for each item.
  template <class Item, class Body>
  void each(const std::vector<Item>& items, const Body& body) {
    for (const Item& item : items)
      group(item.name, [&](LayoutContract& inner) { body(inner, item); });
  }
  /// Accepts a group whose content is compared elsewhere.
  void accept(const std::string& name) { expect_member(name, true); }
  /// Compares a dataset with the text or bytes of a file, which has no attributes.
  void file(const std::string& name);
  /// Records a fault of an item of the group: "ITEM MESSAGE".
  void fault(const std::string& item, const std::string& message);
  /// Records what the group has beyond what was laid out, once all of it was.
  void finish();

 private:
  template <class T>
  static constexpr const char* type_name() {
    if constexpr (std::is_same_v<T, std::string>) return "text";
    if constexpr (std::is_same_v<T, double>) return "float64";
    if constexpr (std::is_same_v<T, std::uint8_t> || std::is_same_v<T, bool>) return "uint8";
    return "int32";
  }
  bool expect_member(const std::string& name, bool is_group);
  void expect_dataset(const std::string& name, const std::string& type,
                      const DatasetAttributes& tags);
  void expect_attribute(const std::string& name, const std::string& type);

  Hdf5Group group_;
  std::string path_, joint_unit_;
  std::vector<std::string>& faults_;
  std::set<std::string> members_, attributes_;
};

}  // namespace morphe::store
