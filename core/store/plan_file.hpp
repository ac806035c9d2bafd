#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/export.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::files {
struct Disk;  // core/files/disk.hpp
}

namespace morphe::store {

/// Writes plans.h5 (docs/formats.md), plan by plan, in the order of the calls. The file appears,
/// whole and synced, with finish(); without it nothing is left behind. InputError: a plan or input
/// that is there already, a demonstration's name that is empty or holds '/', an absolute input
/// path, arrays that do not fit the robot or each other, a disk that does not take it.
class MORPHE_EXPORT PlanWriter {
 public:
  PlanWriter(const std::filesystem::path& path, const PlanFileHeader& header,
             const RobotTable& robot);
  /// To a disk that may fail.
  PlanWriter(const std::filesystem::path& path, const PlanFileHeader& header,
             const RobotTable& robot, files::Disk& disk);
  ~PlanWriter();
  void add(const Plan& plan);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads plans.h5, one plan at a time, in the order in which they were written. What read() returns
/// fits together and fits robot(): lengths agree, indices are in range; InputError
/// "FILE:/h5/path: message" otherwise. Values are not judged: that is for `verify`.
class MORPHE_EXPORT PlanReader {
 public:
  explicit PlanReader(const std::filesystem::path& path);
  ~PlanReader();
  const PlanFileHeader& header() const { return header_; }
  const RobotTable& robot() const { return robot_; }
  std::size_t size() const { return paths_.size(); }
  /// "<demonstration>/<000>"
  const std::vector<std::string>& plan_paths() const { return paths_; }
  Plan read(std::size_t index) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  PlanFileHeader header_;
  RobotTable robot_;
  std::vector<std::string> paths_;
};

}  // namespace morphe::store
