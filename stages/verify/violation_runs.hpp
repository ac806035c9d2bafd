#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stages/verify/violation.hpp"

namespace morphe::verify {

/// Where on a curve: sample k is step 2k, the piece after it is step 2k + 1.
struct CurvePoint {
  int step = 0;
  int sample = 0;  ///< nearest sample
  double time_s = 0;
};

/// Joins what is wrong at neighbouring places with the same cause and subject into one violation,
/// that of the greatest excess. For each cause and subject, places must come in order.
class ViolationRuns {
 public:
  explicit ViolationRuns(std::string plan) : plan_(std::move(plan)) {}

  void note(const std::string& cause, const std::string& subject, const CurvePoint& place,
            double value, double limit, double excess);
  /// Of the plan as a whole: sample -1.
  void note_plan(const std::string& cause, const std::string& subject, double value, double limit);
  /// All that was noted, by sample, cause and subject.
  std::vector<Violation> finish();

 private:
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
