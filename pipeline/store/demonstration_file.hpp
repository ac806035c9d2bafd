#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/motion/demonstration.hpp"

namespace morphe {

/// Writes demonstrations.h5 (docs/formats.md). The file appears, whole and synced, with finish();
/// without it nothing is left behind. InputError: a name that is empty, taken or holds '/'; arrays
/// of one stream that differ in length; a disk that does not take it.
class DemonstrationWriter {
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
/// "FILE:/h5/path: message" for whatever is missing, damaged or does not fit together.
class DemonstrationReader {
 public:
  explicit DemonstrationReader(const std::filesystem::path& path);
  ~DemonstrationReader();
  std::size_t size() const { return names_.size(); }
  const std::vector<std::string>& names() const { return names_; }
  Demonstration read(std::size_t index) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  std::vector<std::string> names_;
};

}  // namespace morphe
