#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"
#include "core/parquet/column.hpp"

namespace morphe::exports {

/// A plan in its file, from which a row of the table is computed.
struct PlanEntry {
  const RobotModel& robot;
  const Plan& plan;
  std::string_view split;  ///< train or valid, "" without a split
};

/// The value of a cell; std::monostate if it is unknown or does not apply.
using Cell = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// A column of the table of quality.
struct PlanColumn {
  std::string_view name;  ///< also in the conditions of --where
  parquet::ValueType type;
  std::string_view unit;  ///< SI; "1" for numbers without a dimension, "" for others
  std::string_view meaning;
  Cell (*value)(const PlanEntry&);
  std::vector<std::string> (*words)() = nullptr;  ///< all values that a text can have; may be null
};

/// Returns the columns, in the order of the table.
std::span<const PlanColumn> plan_columns();

}  // namespace morphe::exports
