#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "stages/export/table/split.hpp"

namespace morphe::exports {

/// Counts of the plans of a file, for the card of a dataset made from it.
struct PlanCounts {
  int plans = 0;                        ///< all of the file
  std::map<std::string, int> statuses;  ///< of all plans
  std::map<std::string, int> reasons;   ///< of the infeasible and partial ones
  int chosen = 0;                       ///< that satisfy the condition and are in the dataset
  /// Source and licence of the recordings of the chosen plans, with the number of plans.
  std::map<std::pair<std::string, std::string>, int> sources;
  std::map<std::string, int> subjects;  ///< likewise
  std::map<std::string, int> sides;     ///< likewise, of the split

  /// Counts a plan of the file.
  void add(const Plan& plan);
  /// Counts a plan of the dataset.
  void add_chosen(const Plan& plan, std::string_view side);
};

/// The sentences of a card beside the counts.
struct CardOptions {
  std::string title;         ///< one line
  std::string front_matter;  ///< YAML for the hub of datasets, or ""
  std::string content;       ///< paragraphs on the files, Markdown
  std::string where;         ///< the condition, or ""
  SplitOptions split;
  std::string not_verified;  ///< as in ExportOptions
};

/// Returns the card of a dataset, README.md: content, yield, sources and licences, persons, split,
/// seeds and versions, and what is assumed. All texts from the file are escaped for Markdown.
std::string dataset_card(const PlanCounts& counts, const CardOptions& options,
                         const PlanFileHeader& header, const RobotModel& robot);

/// Returns a text as it stands in a cell of a Markdown table.
std::string markdown_cell(std::string_view text);

/// Returns the columns of the table as a Markdown table.
std::string columns_markdown();

}  // namespace morphe::exports
