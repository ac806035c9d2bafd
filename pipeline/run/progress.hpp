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

/// How much is said of a run while it lasts.
enum class Detail { nothing, usual, everything };

/// How far a run is, on standard error: a line that changes on a terminal (counts, rate, time left,
/// and what has been in hand for long), otherwise a line for each demonstration, which `everything`
/// prints on a terminal as well. Safe to call from several threads.
class Progress {
 public:
  explicit Progress(Detail detail);
  ~Progress();
  void begin(std::int64_t total, int jobs);
  void takes_in_hand(const std::string& demonstration);
  void has_finished(const std::string& demonstration);
  /// A demonstration that an earlier run had finished.
  void reused(const BatchSummary& summary);
  /// What became of one, in the order of the dataset.
  void done(const std::string& demonstration, const BatchSummary& summary,
            const std::string& error);
  void line(const std::string& text);  ///< beside the progress, also if it says nothing
  /// No more is begun: a line of its own says so at once.
  void stopping();
  BatchSummary so_far() const;

 private:
  using Clock = std::chrono::steady_clock;
  void show(bool now);
  std::string text() const;

  const Detail detail_;
  StatusLine status_;
  mutable std::mutex mutex_;
  bool stopping_ = false;
  std::int64_t total_ = 0;
  BatchSummary sum_;
  WorkSoFar work_;
  std::map<std::string, Clock::time_point> in_hand_;
  Clock::time_point last_shown_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread ticking_;
};

/// What the line says: "37 of 100, 12.3 a minute, 5 min left: 30 executable (2 repaired), 4
/// infeasible, 1 failed"; before one is finished there is neither rate nor time left.
std::string progress_text(const BatchSummary& sum, std::int64_t total, const WorkSoFar& work);

}  // namespace morphe::run
