#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/config/problems.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::config {

/// A YAML value that knows where it stands (file, line, key) and whether it was read. Copies refer
/// to the same document. Everything thrown is an InputError "FILE:LINE: KEY: message".
class ConfigNode {
 public:
  /// Reads a file; throws if it cannot be read, is no YAML, or repeats a key.
  static ConfigNode load(const std::filesystem::path& file);
  /// The same for text; `label` stands for the file's name in messages.
  static ConfigNode parse(const std::string& text, const std::string& label);

  bool is_map() const;
  bool is_list() const;
  bool is_scalar() const;
  bool has(std::string_view key) const;   ///< with a value; "key:" alone counts as absent
  std::vector<std::string> keys() const;  ///< of a map, in the file's order; marks none as read
  ConfigNode operator[](std::string_view key) const;  ///< marks the key as read; throws if missing
  std::vector<ConfigNode> items() const;              ///< of a list; throws if it is none

  std::string text() const;
  bool boolean() const;
  std::int64_t integer() const;
  double number() const;  ///< "177 deg" is converted to radians; .inf and .nan are refused
  Vec3 vec3() const;
  std::vector<double> numbers() const;
  std::vector<std::string> texts() const;

  /// Replaces or adds the value at a dotted path below this node ("map.w_x"); value is YAML.
  void set(const std::string& dotted_path, const std::string& value);
  /// Takes from `base` what is missing here: mappings key by key, anything else as a whole. What is
  /// taken keeps its file and line.
  void extend(const ConfigNode& base);
  /// Takes a key away, read or not; nothing where there is none.
  void erase(std::string_view key);
  /// A copy of this value as a document of its own: its keys are read anew.
  ConfigNode detached() const;
  /// The keys of this document that nobody has read, each with the one that it was probably meant
  /// to be: of those that were asked for in its place.
  void add_unread(Problems& problems) const;
  /// Throws if there are any.
  void expect_all_read() const;
  void expect_map() const;  ///< throws if it is none
  [[noreturn]] void fail(const std::string& message) const;
  /// The same for a message that may begin with the name of a key of this map ("step_s must be
  /// positive"): then it is told of that key, with its line.
  [[noreturn]] void fail_below(const std::string& message) const;

  std::filesystem::path file() const;    ///< as given to load()
  std::filesystem::path folder() const;  ///< of the file this value stands in: paths start there
  int line() const;
  const std::string& key() const { return key_; }  ///< dotted path from the root, "" for the root

 private:
  struct Value;
  struct Document;
  ConfigNode(std::shared_ptr<Document> document, Value* value, std::string key)
      : document_(std::move(document)), value_(value), key_(std::move(key)) {}
  /// A value of another shape than was asked for: what is below it is not told as well.
  [[noreturn]] void fail_shape(const std::string& message) const;

  std::shared_ptr<Document> document_;
  Value* value_ = nullptr;  ///< owned by document_
  std::string key_;
};

}  // namespace morphe::config
