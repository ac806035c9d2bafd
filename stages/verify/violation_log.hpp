#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stages/verify/curve.hpp"
#include "stages/verify/violation.hpp"

namespace morphe::verify {

/// A log of violations. Those of one cause and subject must be recorded in the order of their
/// places. Of those at neighbouring places it keeps the one with the greatest excess.
class ViolationLog {
 public:
  explicit ViolationLog(std::string plan) : plan_(std::move(plan)) {}

  /// Records a violation at a place on the curve.
  void note(const std::string& cause, const std::string& subject, const CurvePoint& place,
            double value, double limit, double excess);
  /// Records a violation of the plan as a whole: sample -1.
  void note_plan(const std::string& cause, const std::string& subject, double value, double limit);
  /// Returns all recorded violations, sorted by sample, cause and subject.
  std::vector<Violation> finish();

 private:
  /// A run of violations at neighbouring places that is still open.
  struct Run {
    Violation worst;
    double excess = 0;
    int last_step = 0;
  };
  std::string plan_;
  std::map<std::pair<std::string, std::string>, Run> open_;
  std::vector<Violation> closed_;
};

}  // namespace morphe::verify
