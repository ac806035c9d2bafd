#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/robot/robot.hpp"
#include "pipeline/commands/plan_figures.hpp"

namespace morphe::commands {

/// What tables say of a plan.
struct PlanRow {
  std::string name;    ///< "<demonstration>/<000>"
  std::string status;  ///< executable, repaired (and executable), approximate or infeasible
  std::string reason;  ///< its code, "" unless infeasible
  FigureValues figures{};
  bool against_estimate = false;   ///< shoulder or elbow were not recorded
  std::vector<std::string> lines;  ///< why it is infeasible, what to try, notes, findings
  WorldFrames world;               ///< where things stand
  std::map<std::string, std::string> remarks;  ///< scene_remarks()

  bool executable() const { return status == name_of(Status::executable) || status == "repaired"; }
};
PlanRow row_of(const robot::Robot& robot, const Plan& plan);

/// As a run's journal keeps it: one line. Bit for bit the same when read back.
std::string row_text(const PlanRow& row);
PlanRow row_from_text(const std::string& text);

/// Which rows are shown, and in what order.
struct RowChoice {
  std::string sort;               ///< the key of a figure (the worst first) or name; "" as they are
  std::vector<std::string> only;  ///< each a status, a reason or a pattern of names
};

/// InputError names the keys there are.
void check_choice(const RowChoice& choice);
/// executable counts what was repaired; a pattern (* and ?) may leave out the movement.
bool chosen(const RowChoice& choice, const PlanRow& row);
/// Rows without the figure come last.
void sort_rows(const RowChoice& choice, std::vector<PlanRow>& rows);

/// The table with everything that stands below its rows.
std::string plan_table(const std::vector<PlanRow>& rows, std::size_t width);

}  // namespace morphe::commands
