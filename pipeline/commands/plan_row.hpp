#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/arm_branch.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/commands/plan_figures.hpp"
#include "pipeline/explain/advice.hpp"

namespace morphe::commands {

/// The data of a plan shown in tables.
struct PlanRow {
  std::string name;    ///< "<demonstration>/<000>"
  std::string status;  ///< executable, repaired (and executable), approximate, partial, infeasible
  std::string reason;  ///< code, "" unless infeasible or partial
  FigureValues figures{};
  bool arm_estimated = false;  ///< true if shoulder or elbow were not recorded
  std::vector<std::string>
      lines;  ///< reason for an infeasible or partial plan, advice, notes, findings
  ArmBranch branch;
  WorldFrames world;
  std::map<std::string, std::string> remarks;  ///< scene_remarks()
  std::vector<Assumption> assumptions;         ///< plan_assumptions()
  std::vector<KindClearance> clearances;       ///< of the certificate

  /// Returns true for executable plans, including repaired ones.
  bool executable() const { return status == name_of(Status::executable) || status == "repaired"; }
};
/// Computes the row of a plan. `context` is that of the config of its run, for advice.
PlanRow row_of(const robot::Robot& robot, const Plan& plan,
               const explain::AdviceContext& context = {});

/// The status of a plan that `verify` rejects.
inline constexpr const char* kNotVerified = "not verified";
/// Removes from a row all that rests on the plan's word, and gives it kNotVerified and the
/// violation; does nothing if the violation is "".
void distrust(PlanRow& row, const std::string& violation);

/// Converts a row to one line of JSON, as the journal of a run stores it.
std::string row_to_json(const PlanRow& row);
/// Converts the JSON back to an identical row.
PlanRow row_from_json(const std::string& text);

/// The selection and the order of the rows shown.
struct RowSelection {
  std::string sort_key;  ///< key of a figure (worst rows first) or name, "" for the original order
  std::vector<std::string> filters;  ///< each a status, a reason or a pattern of names
};

/// Returns the keys by which rows can be sorted.
std::vector<std::string> sort_keys();
/// Returns the statuses and reasons by which rows can be filtered.
std::vector<std::string> filter_words();

/// Throws InputError with the list of valid keys if the key is invalid.
void check_selection(const RowSelection& choice);
/// Returns the message for a filter that is no status and no reason and fits none of the plans of
/// these names, or "".
std::string unknown_filter(const RowSelection& choice, const std::vector<std::string>& plan_names);
/// Throws that message as InputError "--only: …".
void check_filters(const RowSelection& choice, const std::vector<std::string>& plan_names);
/// Returns true if a row satisfies all filters; "executable" includes repaired plans.
bool is_selected(const RowSelection& choice, const PlanRow& row);
/// Sorts the rows. Rows without the figure come last.
void sort_rows(const RowSelection& choice, std::vector<PlanRow>& rows);

/// Returns the table with all lines below its rows.
std::string plan_table(const std::vector<PlanRow>& rows, std::size_t width);

}  // namespace morphe::commands
