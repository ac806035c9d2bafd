#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/config/error_list.hpp"
#include "core/files/given_files.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/input_error.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::config {

/// A YAML value that stores its position (file, line, key) and whether it was read. Copies refer to
/// the same document. Errors are thrown as InputError "FILE:LINE: KEY: message".
class ConfigNode {
 public:
  /// Reads a file of the disk or, if there are any, of the given files, which must outlive the
  /// document; throws if it cannot be read, is not YAML, or repeats a key.
  static ConfigNode load(const std::filesystem::path& file,
                         const files::GivenFiles* given = nullptr);
  /// Parses a text; `label` is used as the file's name in messages.
  static ConfigNode parse(const std::string& text, const std::string& label);

  /// Returns true if the value is a map.
  bool is_map() const;
  /// Returns true if the value is a list.
  bool is_list() const;
  /// Returns true if the value is a scalar.
  bool is_scalar() const;
  /// Returns true if this is a map whose key has a value; "key:" alone counts as absent.
  bool has(std::string_view key) const;
  /// Returns the keys of a map, in the file's order, without marking them as read.
  std::vector<std::string> keys() const;
  /// Returns the value of a key and marks the key as read; throws if it is missing.
  ConfigNode operator[](std::string_view key) const;
  /// Returns the items of a list; throws if the value is not a list.
  std::vector<ConfigNode> items() const;

  /// Returns the text of a scalar; throws if the value is not a scalar.
  std::string text() const;
  /// Returns a boolean; throws if the value is not one.
  bool boolean() const;
  /// Returns an integer; throws if the value is not one.
  std::int64_t integer() const;
  /// Returns an integer within bounds; throws otherwise.
  std::int64_t integer(const KeyBounds& bounds) const;
  /// Returns a number; "177 deg" is converted to radians, .inf and .nan are rejected.
  double number() const;
  /// Returns a number within bounds; throws otherwise.
  double number(const KeyBounds& bounds) const;
  /// Returns a list of three numbers within bounds as a vector; throws otherwise.
  Vec3 vec3(const KeyBounds& bounds) const;
  /// Returns a list of numbers within bounds; throws otherwise.
  std::vector<double> numbers(const KeyBounds& bounds) const;
  /// Returns a list of texts; throws otherwise.
  std::vector<std::string> texts() const;

  /// Sets the value at a dotted path below this node ("map.w_x"), as --set does; `value` is YAML.
  void set(const std::string& dotted_path, const std::string& value);
  /// Adds the values of `base` that are missing here: mappings key by key, other values as a whole.
  /// Added values keep their file and line.
  void extend(const ConfigNode& base);
  /// Removes a key, whether it was read or not; it may be absent.
  void erase(std::string_view key);
  /// Returns a copy of this value as a document of its own: reading it marks no keys here.
  ConfigNode copy_as_document() const;
  /// Adds the document's unread keys to the errors, each with the most similar one requested there.
  void report_unread_keys(ErrorList& problems) const;
  /// Throws if there are any unread keys.
  void require_all_keys_read() const;
  /// Throws if the value is not a map.
  void expect_map() const;
  /// Throws InputError about this value.
  [[noreturn]] void fail(const std::string& message) const;
  /// Throws InputError about the key of this map that begins the message ("step_s must …").
  [[noreturn]] void fail_at_key(const std::string& message) const;

  std::filesystem::path file() const;  ///< that contains this value
  /// Returns the folder of the file that contains this value, to which paths are relative.
  std::filesystem::path folder() const;
  /// Returns the files in memory among which the document's file names others; nullptr if they are
  /// on the disk.
  const files::GivenFiles* given() const;
  /// Returns the line of this value in its file.
  int line() const;
  /// Returns the dotted path from the root, "" for the root.
  const std::string& key() const { return key_; }

 private:
  struct Value;
  struct Document;
  ConfigNode(std::shared_ptr<Document> document, Value* value, std::string key)
      : document_(std::move(document)), value_(value), key_(std::move(key)) {}
  /// Throws for a value of an unexpected kind; its children are not reported as unread too.
  [[noreturn]] void fail_shape(const std::string& message) const;
  /// Throws for a number that is out of bounds, in its own words ("177 deg").
  [[noreturn]] void fail_at_value(const KeyBounds& bounds) const;

  std::shared_ptr<Document> document_;
  Value* value_ = nullptr;  ///< owned by document_
  std::string key_;
};

}  // namespace morphe::config
