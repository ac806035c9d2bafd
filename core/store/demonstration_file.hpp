#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/export.hpp"

namespace morphe::store {

/// Writes demonstrations.h5 (docs/formats.md). finish() makes the complete, synced file appear at
/// its path; without it no file is left behind. Throws InputError for a name that is empty, in use
/// or contains '/', for inconsistent data (consistency.hpp), and for write errors of the disk.
class MORPHE_EXPORT DemonstrationWriter {
 public:
  /// Creates the file.
  explicit DemonstrationWriter(const std::filesystem::path& path);
  ~DemonstrationWriter();
  /// Writes a demonstration.
  void add(const Demonstration& demonstration);
  /// Completes the file and moves it to its path.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads demonstrations.h5, one demonstration at a time, in the order in which they were written
/// (by name if the file does not store the order). Absent streams are nullopt. Throws InputError
/// "FILE:/h5/path: message" for data that is missing, damaged or inconsistent, and if the file has
/// changed since it was opened.
class MORPHE_EXPORT DemonstrationReader {
 public:
  /// Opens the file.
  explicit DemonstrationReader(const std::filesystem::path& path);
  ~DemonstrationReader();
  /// Visits all names in order without storing them.
  void each_name(const std::function<void(const std::string&)>& visit) const;
  /// Reads the demonstration with this name.
  Demonstration read(const std::string& name) const;
  /// Throws InputError if the file has changed; read() checks this too.
  void expect_unchanged() const;
  /// Returns the number of samples of the longest stream without reading it.
  std::size_t longest_stream_samples(const std::string& name) const;

  /// Returns the number of demonstrations.
  std::size_t size() const { return names().size(); }
  /// Returns all names in order; they are stored from the first call on.
  const std::vector<std::string>& names() const;
  /// Reads the demonstration with this index in names().
  Demonstration read(std::size_t index) const { return read(names().at(index)); }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace morphe::store
