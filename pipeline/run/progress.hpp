#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "pipeline/run/batch.hpp"
#include "pipeline/run/status_line.hpp"
#include "pipeline/run/time_left.hpp"

namespace morphe::run {

/// The amount of progress information that is printed during a run.
enum class Verbosity { quiet, normal, verbose };

/// The progress of a run on standard error. On a terminal, a status line shows counts, rate,
/// remaining time and the longest running demonstration. Otherwise, and if `verbose`, each finished
/// demonstration prints a line. It is safe to call from several threads.
class Progress {
 public:
  explicit Progress(Verbosity detail);
  ~Progress();
  /// Begins a run of `total` demonstrations on `jobs` threads.
  void begin(std::int64_t total, int jobs);
  /// Records the time at which a demonstration starts or ends.
  void start_demonstration(const std::string& demonstration);
  void finish_demonstration(const std::string& demonstration);
  /// Adds a demonstration that an earlier run had finished.
  void add_reused(const BatchSummary& summary);
  /// Adds the result of a demonstration, in the order of the dataset.
  void add_result(const std::string& demonstration, const BatchSummary& summary,
                  const std::string& error);
  /// Prints a line beside the progress, also in quiet mode.
  void line(const std::string& text);
  /// Announces at once that the demonstrations in progress are the last.
  void announce_stop();
  /// Returns the sum over the results added so far.
  BatchSummary current_summary() const;

 private:
  using Clock = std::chrono::steady_clock;
  void show(bool now);
  std::string text() const;

  const Verbosity detail_;
  StatusLine status_;
  mutable std::mutex mutex_;
  bool stopping_ = false;
  std::int64_t total_ = 0;
  BatchSummary sum_;
  RunWorkload work_;
  std::map<std::string, Clock::time_point> running_;
  Clock::time_point last_shown_;
  std::condition_variable wake_;
  bool ending_ = false;
  std::thread refresher_;
};

/// Returns "37 of 100, 12.3 per minute, 5 min left: 30 executable (2 repaired), 4 infeasible, 1
/// failed". Rate and remaining time are left out before a demonstration is finished.
std::string progress_text(const BatchSummary& sum, std::int64_t total, const RunWorkload& work);

}  // namespace morphe::run
