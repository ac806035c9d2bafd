#pragma once

#include <string>
#include <vector>

#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe {

/// What a person wants to see of each plan after a run: a row per plan, a line of explanation for
/// those that are infeasible, and how much of the placement's goals the robot reaches.
class PlanReport {
 public:
  explicit PlanReport(const RobotTable& robot) : robot_(robot) {}
  void add(const Plan& plan);
  std::string table() const;

 private:
  const RobotTable& robot_;
  std::vector<std::string> rows_;
  std::size_t goals_ = 0, unreachable_ = 0;
};

}  // namespace morphe
