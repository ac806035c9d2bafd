#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "pipeline/run/batch.hpp"

namespace morphe::run {

/// How far a run is, on standard error: one line that changes on a terminal (rate, time left,
/// counts), otherwise a line for each demonstration.
class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  void begin(std::int64_t total);
  /// A demonstration that an earlier run had finished.
  void reused(const BatchSummary& summary);
  void done(const std::string& demonstration, const BatchSummary& summary,
            const std::string& error);
  void line(const std::string& text);  ///< beside the progress, also if it is quiet
  const BatchSummary& so_far() const { return sum_; }

 private:
  using Clock = std::chrono::steady_clock;
  void show(bool now);
  void clear();

  bool quiet_, terminal_, shown_ = false;
  std::int64_t total_ = 0;
  BatchSummary sum_;
  Clock::time_point begin_, last_shown_;
};

/// "37 of 100, 12.3 a minute, 5 min left: 30 executable (2 repaired), 4 infeasible, 1 failed".
std::string progress_text(const BatchSummary& sum, std::int64_t total, double elapsed_s);

}  // namespace morphe::run
