#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "core/files/disk.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::store {

/// An HDF5 identifier that is closed in its destructor. (This header does not need hdf5.h.)
class Hdf5Id {
 public:
  using Id = std::int64_t;    ///< hid_t
  using Close = int (*)(Id);  ///< herr_t
  Hdf5Id() = default;
  /// Owns an identifier, to be closed with `close`.
  Hdf5Id(Id id, Close close) : id_(id), close_(close) {}
  Hdf5Id(Hdf5Id&& other) noexcept;
  Hdf5Id& operator=(Hdf5Id&& other) noexcept;
  ~Hdf5Id() { reset(); }

  /// Returns true if there is an open identifier.
  bool valid() const { return id_ >= 0; }
  /// Returns the identifier.
  Id get() const { return id_; }
  /// Closes the identifier. Returns false if that failed, so that a file's data may be lost.
  bool reset();

 private:
  Id id_ = -1;
  Close close_ = nullptr;
};

/// A dimension of any length, in a shape that a reader requires.
inline constexpr std::size_t kAnyLength = std::numeric_limits<std::size_t>::max();
/// The dimensions of a dataset.
using Hdf5Shape = std::vector<std::size_t>;
/// Returns true if the dimensions are those required, of which some may be kAnyLength.
bool has_shape(const Hdf5Shape& dims, const Hdf5Shape& required);

/// The values of a dataset, row-major.
template <class T>
struct Hdf5Array {
  Hdf5Shape dims;
  std::vector<T> values;
};

/// The content of a dataset or attribute of any type: numbers or texts.
struct Hdf5Value {
  Hdf5Shape dims;
  bool is_text = false;
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// A group of an open file. Datasets are chunked with a Fletcher-32 checksum, so that damage is
/// detected when reading; those without elements are contiguous. Strings are UTF-8, written with
/// fixed length; strings of variable length, as written by h5py, can be read too. Scalars: double,
/// std::int32_t, std::uint8_t. Items that are missing, damaged or of another type or shape throw
/// InputError "FILE:/h5/path: message".
class Hdf5Group {
 public:
  Hdf5Group() = default;
  /// Owns an open group; `file` and `path` are used in messages.
  Hdf5Group(Hdf5Id id, std::string file, std::string path)
      : id_(std::move(id)), file_(std::move(file)), path_(std::move(path)) {}

  /// Creates a group. Links keep the order of their creation. Throws InputError if the name is not
  /// valid for a single link, or in use.
  Hdf5Group create(const std::string& name) const;
  /// Writes a dataset.
  template <class T>
  void write(const std::string& name, const Hdf5Array<T>& array) const;
  /// Writes a dataset of strings.
  void write_strings(const std::string& name, const std::vector<std::string>& values) const;
  /// Writes a text as a scalar dataset.
  void write_text(const std::string& name, const std::string& text) const;

  /// Sets an attribute of this group (".") or of one of its datasets.
  void set(const std::string& name, const std::string& text, const char* dataset = ".") const;
  /// Sets an attribute of this group.
  template <class T>
  requires(std::is_arithmetic_v<T>) void set(const std::string& name, T value) const;
  /// Sets an attribute of this group.
  void set(const std::string& name, const std::vector<double>& values) const;
  /// Sets an attribute of this group.
  void set(const std::string& name, const std::vector<std::string>& values) const;

  /// Returns true if there is a link of that name.
  bool has(const std::string& name) const;
  /// Returns true if the link of that name is a group.
  bool is_group(const std::string& name) const;
  /// Opens a group.
  Hdf5Group open(const std::string& name) const;
  /// Returns the names of the links, in order of creation if the file stores it, else by name.
  std::vector<std::string> children() const;
  /// Visits the names of the links one by one, in the same order, without storing them.
  void each_child(const std::function<void(const std::string&)>& visit) const;
  /// Returns the first dimension of a dataset; 1 for a scalar.
  std::size_t length(const std::string& name) const;
  /// Reads a dataset, which must have the given shape (kAnyLength: any).
  template <class T>
  Hdf5Array<T> read(const std::string& name, const Hdf5Shape& shape) const;
  /// Reads a dataset of strings.
  std::vector<std::string> read_strings(const std::string& name) const;
  /// Reads a scalar dataset with a text.
  std::string read_text(const std::string& name) const;

  /// Returns the type of a dataset's elements: "float64", "int32", "uint8", "text" or another.
  std::string type_of(const std::string& name) const;
  /// Returns the type of an attribute of this group, likewise.
  std::string type_of_attribute(const std::string& name) const;

  /// Reads a dataset with numbers or texts.
  Hdf5Value value(const std::string& name) const;

  /// Returns true if this group has the attribute.
  bool has_attribute(const std::string& name) const;
  /// Returns the names of the attributes of this group or of one of its datasets, sorted.
  std::vector<std::string> attributes(const char* dataset = ".") const;
  /// Reads an attribute with numbers or texts.
  Hdf5Value value_of_attribute(const std::string& name, const char* dataset = ".") const;
  /// Reads an attribute of this group, or of one of its datasets: a scalar, a text, or a vector of
  /// doubles or texts.
  template <class T>
  void get(const std::string& name, T& value, const char* dataset = ".") const;

  /// Throws InputError about this group.
  [[noreturn]] void fail(const std::string& message) const;
  /// Throws InputError with a fault "item/below/this/group: message", unless the fault is "".
  void throw_if_fault(const std::string& fault) const;
  /// Throws InputError about an item of this group.
  [[noreturn]] void fail(const std::string& name, const std::string& message) const;

 private:
  std::string where(const std::string& name) const;
  std::size_t file_bytes() const;

  Hdf5Id id_;
  std::string file_, path_;
};

/// An HDF5 file. The same calls write the same bytes, because no times are stored. It must be used
/// by one thread at a time.
class Hdf5File {
 public:
  Hdf5File() = default;
  /// Creates or overwrites a file; throws InputError if it cannot be created.
  static Hdf5File create(const std::filesystem::path& path, files::Disk& disk = files::real_disk());
  /// Opens a file for reading; throws InputError if it is missing, empty, truncated or not HDF5.
  static Hdf5File open(const std::filesystem::path& path);

  /// Returns the root group.
  Hdf5Group root() const;
  /// Throws InputError if the file was truncated or written to since it was opened, because HDF5
  /// itself reads a missing end as zeros. A file that was removed remains readable.
  void expect_unchanged() const;
  /// Sets the name used in messages, if it is not the path.
  void set_display_name(const std::filesystem::path& path) { name_ = path.string(); }
  /// Throws InputError if data that was written did not reach the disk.
  void expect_written() const;
  /// Flushes and closes the file; throws InputError if some data could not be written.
  void close();

 private:
  Hdf5Id id_;
  std::string name_;
  /// The size of the file and the time of its last change.
  struct State {
    std::int64_t bytes = 0, seconds = 0, nanoseconds = 0;
    bool operator==(const State&) const = default;
  } opened_;
  State state() const;
  void expect_written(int error) const;
};

/// Writes the root attributes `format` and `version` [int].
void write_format(const Hdf5Group& root, const std::string& format, int version);
/// Throws InputError if the file has another format or another version.
void check_format(const Hdf5Group& root, const std::string& format, int version);

}  // namespace morphe::store
