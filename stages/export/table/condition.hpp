#pragma once

#include <memory>
#include <optional>
#include <string>

#include "stages/export/table/plan_columns.hpp"

namespace morphe::exports {

/// A condition on the columns of the table, as --where takes it:
///
///     clearance > 2 mm and (tempo < 1.8 or not repaired)
///
/// A comparison is a column, one of < <= > >= = !=, and a value: a number with a unit, if the
/// column has one (m cm mm um, rad deg, s ms, m^2 cm^2 mm^2, N, %), a word or a text in quotes, or
/// true or false, which may be left out after the name of a flag. Words and flags are compared with
/// = and != only. `and` binds closer than `or`, `not` closer than both. A comparison with an
/// unknown value is unknown, and so is what depends on it (Kleene's logic); a plan satisfies the
/// condition only if it is true.
class Condition {
 public:
  /// Parses the text. Throws InputError "--where: … at character N: …", of one line, for anything
  /// that is not such a condition.
  explicit Condition(const std::string& text);
  ~Condition();
  Condition(Condition&&) noexcept;

  /// Returns true if the plan satisfies the condition.
  bool holds(const PlanEntry& entry) const;

  struct Node;

 private:
  std::unique_ptr<Node> root_;
};

}  // namespace morphe::exports
