#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/export.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::files {
struct Disk;  // core/files/disk.hpp
}

namespace morphe::store {

/// Writes plans.h5 (docs/formats.md), plan by plan, in the order of the calls. finish() makes the
/// complete, synced file appear at its path; without it no file is left behind. Throws InputError
/// for a plan or input that is already in the file, for a demonstration's name that is empty or
/// contains '/', for an absolute input path, for inconsistent arrays (consistency.hpp), and for
/// write errors of the disk.
class MORPHE_EXPORT PlanWriter {
 public:
  /// Creates the file.
  PlanWriter(const std::filesystem::path& path, const PlanFileHeader& header,
             const RobotModel& robot);
  /// Writes to a disk that may fail.
  PlanWriter(const std::filesystem::path& path, const PlanFileHeader& header,
             const RobotModel& robot, files::Disk& disk);
  ~PlanWriter();
  /// Writes a plan.
  void add(const Plan& plan);
  /// Completes the file and moves it to its path.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads plans.h5, one plan at a time, in the order in which they were written. Throws InputError
/// "FILE:/h5/path: message" for data that is missing, damaged or inconsistent: lengths of arrays in
/// a plan agree with each other and with robot(), and indices are in range. Values are not checked,
/// which is the task of `verify`.
class MORPHE_EXPORT PlanReader {
 public:
  /// Opens the file.
  explicit PlanReader(const std::filesystem::path& path);
  ~PlanReader();
  /// Returns the header of the file.
  const PlanFileHeader& header() const { return header_; }
  /// Returns the robot of all plans.
  const RobotModel& robot() const { return robot_; }
  /// Returns the number of plans.
  std::size_t size() const { return paths_.size(); }
  /// Returns the paths "<demonstration>/<000>" of all plans.
  const std::vector<std::string>& plan_paths() const { return paths_; }
  /// Reads the plan with this index in plan_paths().
  Plan read(std::size_t index) const;
  /// Returns what the file has, beside the content of its plans, that PlanWriter would not write
  /// for this header and robot, and what it lacks: members, attributes, types and units
  /// (layout_contract.hpp). Readers ignore these, but a person or another program may trust them.
  std::vector<std::string> contract_faults() const;
  /// Returns the same for the plan with this index, as read.
  std::vector<std::string> contract_faults(std::size_t index, const Plan& plan) const;

 private:
  /// Returns the names of the demonstration and of the movement.
  std::pair<std::string, std::string> names_of(std::size_t index) const;

  struct State;
  std::unique_ptr<State> state_;
  PlanFileHeader header_;
  RobotModel robot_;
  std::vector<std::string> paths_;
};

}  // namespace morphe::store
