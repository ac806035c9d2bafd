#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/files/disk.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::store {

/// An HDF5 identifier that closes itself. (hdf5.h itself stays in the .cpp files.)
class Hdf5Id {
 public:
  using Id = std::int64_t;    ///< hid_t
  using Close = int (*)(Id);  ///< herr_t
  Hdf5Id() = default;
  Hdf5Id(Id id, Close close) : id_(id), close_(close) {}
  Hdf5Id(Hdf5Id&& other) noexcept;
  Hdf5Id& operator=(Hdf5Id&& other) noexcept;
  ~Hdf5Id() { reset(); }

  bool valid() const { return id_ >= 0; }
  Id get() const { return id_; }
  /// False if HDF5 could not close it (a file: what was still buffered is not written).
  bool reset();

 private:
  Id id_ = -1;
  Close close_ = nullptr;
};

/// Values of a dataset, row-major.
template <class T>
struct Hdf5Array {
  std::vector<std::size_t> dims;
  std::vector<T> values;
};

/// Whatever a dataset or an attribute holds: numbers of any kind, or texts.
struct Hdf5Value {
  std::vector<std::size_t> dims;
  bool is_text = false;
  std::vector<double> numbers;
  std::vector<std::string> texts;
};

/// In the shape that a reader asks for: any length.
inline constexpr std::size_t kAnyLength = static_cast<std::size_t>(-1);
using Hdf5Shape = std::vector<std::size_t>;

/// A group of an open file. Datasets are chunked with a Fletcher-32 checksum, so that damage fails
/// at reading; those without elements are contiguous. Strings are UTF-8, written in fixed length;
/// those of variable length, as h5py writes them, are read too. Scalars: double, std::int32_t,
/// std::uint8_t. Whatever is missing, damaged or of another type or shape throws InputError
/// "FILE:/h5/path: message".
class Hdf5Group {
 public:
  Hdf5Group() = default;
  Hdf5Group(Hdf5Id id, std::string file, std::string path)
      : id_(std::move(id)), file_(std::move(file)), path_(std::move(path)) {}

  /// Links keep the order of their creation. InputError if the name is not one link's name, or is
  /// taken.
  Hdf5Group create(const std::string& name) const;
  template <class T>
  void write(const std::string& name, const Hdf5Array<T>& array) const;
  void write_strings(const std::string& name, const std::vector<std::string>& values) const;
  void write_text(const std::string& name, const std::string& text) const;  ///< scalar dataset

  /// An attribute of this group, or of one of its datasets.
  void set(const std::string& name, const std::string& text, const char* dataset = ".") const;
  void set(const std::string& name, double value) const;
  void set(const std::string& name, std::int32_t value) const;
  void set(const std::string& name, std::uint8_t value) const;
  void set(const std::string& name, const std::vector<double>& values) const;
  void set(const std::string& name, const std::vector<std::string>& values) const;

  bool has(const std::string& name) const;
  bool is_group(const std::string& name) const;
  Hdf5Group open(const std::string& name) const;
  /// Names of the links: in the order of their creation where the file holds it, else by name.
  std::vector<std::string> children() const;
  /// The same, one by one, without holding them all.
  void each_child(const std::function<void(const std::string&)>& visit) const;
  /// First dimension of a dataset.
  std::size_t length(const std::string& name) const;
  template <class T>
  Hdf5Array<T> read(const std::string& name, const Hdf5Shape& shape) const;
  std::vector<std::string> read_strings(const std::string& name) const;
  std::string read_text(const std::string& name) const;

  Hdf5Value value(const std::string& name) const;

  bool has_attribute(const std::string& name) const;
  std::vector<std::string> attributes(const char* dataset = ".") const;  ///< names, sorted
  Hdf5Value value_of_attribute(const std::string& name, const char* dataset = ".") const;
  void get(const std::string& name, std::string& text, const char* dataset = ".") const;
  void get(const std::string& name, double& value) const;
  void get(const std::string& name, std::int32_t& value) const;
  void get(const std::string& name, std::uint8_t& value) const;
  void get(const std::string& name, std::vector<double>& values) const;
  void get(const std::string& name, std::vector<std::string>& values) const;

  [[noreturn]] void fail(const std::string& message) const;  ///< about this group
  /// Fails with "path/below: message", unless it is empty.
  void refuse(const std::string& fault) const;
  [[noreturn]] void fail(const std::string& name, const std::string& message) const;

 private:
  std::string where(const std::string& name) const;
  std::size_t file_bytes() const;

  Hdf5Id id_;
  std::string file_, path_;
};

/// The same calls write the same bytes: no times are stored. One thread at a time.
class Hdf5File {
 public:
  Hdf5File() = default;
  /// Overwrites; InputError if the file cannot be created.
  static Hdf5File create(const std::filesystem::path& path, files::Disk& disk = files::real_disk());
  /// Read only; InputError if it is missing, empty, truncated or not HDF5.
  static Hdf5File open(const std::filesystem::path& path);

  Hdf5Group root() const;
  /// InputError if the file was truncated or written to since it was opened: HDF5 itself takes what
  /// is missing at the end for zeros. A file that was removed stays readable.
  void expect_unchanged() const;
  /// Name in messages, if it is not the path.
  void call_it(const std::filesystem::path& path) { name_ = path.string(); }
  /// InputError if something that was written did not reach the disk.
  void expect_written() const;
  /// Flushes and closes; InputError if not everything could be written.
  void close();

 private:
  Hdf5Id id_;
  std::string name_;
  struct State {
    std::int64_t bytes = 0, seconds = 0, nanoseconds = 0;
    bool operator==(const State&) const = default;
  } opened_;  ///< size and time of the last change
  State state() const;
  void expect_written(int error) const;
};

/// Root attributes `format` and `version` [int].
void write_format(const Hdf5Group& root, const std::string& format, int version);
/// InputError if the file is of another format or of a higher version.
void check_format(const Hdf5Group& root, const std::string& format, int version);

}  // namespace morphe::store
