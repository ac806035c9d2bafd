#include "core/store/layout_contract.hpp"

#include <fmt/format.h>

#include "core/files/printable.hpp"

namespace morphe::store {
namespace {

constexpr const char* kNotInFormat = "is not part of the format";

}  // namespace

void LayoutContract::fault(const std::string& item, const std::string& message) {
  faults_.push_back(fmt::format("{}{} {}", files::make_printable(path_),
                                files::make_printable(item), files::make_printable(message)));
}

bool LayoutContract::expect_member(const std::string& name, bool is_group) {
  members_.insert(name);
  if (!group_.has(name)) {
    fault(name, "is missing");
    return false;
  }
  if (group_.is_group(name) == is_group) return true;
  fault(name, is_group ? "is no group" : "is a group");
  return false;
}

void LayoutContract::expect_dataset(const std::string& name, const std::string& type,
                                    const DatasetAttributes& tags) {
  if (!expect_member(name, false)) return;
  const std::string stored_type = group_.type_of(name);
  if (stored_type != type) fault(name, fmt::format("has the type {}, not {}", stored_type, type));
  struct Tag {
    const char* name;
    std::string text;
    bool required;
  };
  const Tag expected[] = {{"unit", with_joint_unit(tags.unit, joint_unit_), true},
                          {"frame", tags.frame, !tags.frame.empty()},
                          {"meaning", tags.meaning, !tags.meaning.empty()}};
  std::vector<std::string> stored = group_.attributes(name.c_str());
  for (const Tag& tag : expected) {
    if (!tag.required) continue;
    const std::string item = fmt::format("{}@{}", name, tag.name);
    if (std::erase(stored, tag.name) == 0) {
      fault(item, "is missing");
      continue;
    }
    const Hdf5Value value = group_.value_of_attribute(tag.name, name.c_str());
    const std::string found = value.texts.size() == 1 ? value.texts.front() : "no text";
    if (found != tag.text) fault(item, fmt::format("is '{}', not '{}'", found, tag.text));
  }
  for (const std::string& other : stored) fault(fmt::format("{}@{}", name, other), kNotInFormat);
}

void LayoutContract::file(const std::string& name) {
  if (!expect_member(name, false)) return;
  for (const std::string& attribute : group_.attributes(name.c_str()))
    fault(fmt::format("{}@{}", name, attribute), kNotInFormat);
}

void LayoutContract::expect_attribute(const std::string& name, const std::string& type) {
  attributes_.insert(name);
  if (!group_.has_attribute(name)) {
    fault("@" + name, "is missing");
    return;
  }
  const std::string stored = group_.type_of_attribute(name);
  if (stored != type) fault("@" + name, fmt::format("has the type {}, not {}", stored, type));
}

void LayoutContract::finish() {
  group_.each_child([&](const std::string& name) {
    if (!members_.contains(name)) fault(name, kNotInFormat);
  });
  for (const std::string& name : group_.attributes()) {
    if (!attributes_.contains(name)) fault("@" + name, kNotInFormat);
  }
}

}  // namespace morphe::store
