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

/// Writes demonstrations.h5 (docs/formats.md). The file appears, whole and synced, with finish();
/// without it nothing is left behind. InputError: a name that is empty, taken or holds '/'; arrays
/// of one stream that differ in length; a disk that does not take it.
class MORPHE_EXPORT DemonstrationWriter {
 public:
  explicit DemonstrationWriter(const std::filesystem::path& path);
  ~DemonstrationWriter();
  void add(const Demonstration& demonstration);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads demonstrations.h5, one demonstration at a time, in the order in which they were written
/// (by name where the file does not say). Streams that are absent are nullopt. InputError
/// "FILE:/h5/path: message" for whatever is missing, damaged or does not fit together, and for a
/// file that changed since it was opened.
class MORPHE_EXPORT DemonstrationReader {
 public:
  explicit DemonstrationReader(const std::filesystem::path& path);
  ~DemonstrationReader();
  /// All names in their order, without holding them.
  void each_name(const std::function<void(const std::string&)>& visit) const;
  Demonstration read(const std::string& name) const;
  void expect_unchanged() const;  ///< what read() asks of the file, too
  /// Samples of its longest stream, told without reading it.
  std::size_t frames(const std::string& name) const;

  std::size_t size() const { return names().size(); }
  const std::vector<std::string>& names() const;  ///< kept from the first call on
  Demonstration read(std::size_t index) const { return read(names().at(index)); }

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace morphe::store
