#include "pipeline/run/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/count_with_noun.hpp"

namespace morphe::run {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

std::string progress_text(const BatchSummary& sum, std::int64_t total, const RunWorkload& work) {
  std::string text = fmt::format("{} of {}", sum.demonstrations, total);
  const double each_s = seconds_per_demonstration(work);
  if (std::isfinite(each_s) && each_s > 0) {
    const double rate = work.jobs / each_s;
    text += rate >= 1 ? fmt::format(", {:.1f} per second", rate)
                      : fmt::format(", {:.1f} per minute", 60 * rate);
    text += fmt::format(", {} left", duration_text(time_left_s(work)));
  }
  text += fmt::format(": {} executable ({} repaired), ", sum.executable, sum.repaired);
  if (sum.approximate > 0) text += fmt::format("{} approximate, ", sum.approximate);
  if (sum.partial > 0) text += fmt::format("{} partial, ", sum.partial);
  text += fmt::format("{} infeasible", sum.infeasible);
  return sum.failed > 0 ? text + fmt::format(", {} failed", sum.failed) : text;
}

Progress::Progress(Verbosity detail) : detail_(detail) {
  if (detail_ == Verbosity::quiet || !status_.on_terminal()) return;
  try {
    refresher_ = std::thread([this] {
      std::unique_lock lock(mutex_);
      while (!wake_.wait_for(lock, std::chrono::seconds(1), [this] { return ending_; })) show(true);
    });
  } catch (const std::system_error&) {  // then the line changes only with each demonstration
  }
}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  if (refresher_.joinable()) refresher_.join();
}

void Progress::begin(std::int64_t total, int jobs) {
  const std::lock_guard lock(mutex_);
  total_ = total;
  work_.jobs = jobs;
  show(true);
}

void Progress::start_demonstration(const std::string& demonstration) {
  const std::lock_guard lock(mutex_);
  running_[demonstration] = Clock::now();
}

void Progress::finish_demonstration(const std::string& demonstration) {
  const std::lock_guard lock(mutex_);
  const auto entry = running_.find(demonstration);
  work_.finished_total_s += seconds_since(entry->second);
  ++work_.finished;
  running_.erase(entry);
}

void Progress::add_reused(const BatchSummary& summary) {
  const std::lock_guard lock(mutex_);
  add(summary, sum_);
  ++sum_.reused;
  show(false);
}

void Progress::add_result(const std::string& demonstration, const BatchSummary& summary,
                          const std::string& error) {
  const std::lock_guard lock(mutex_);
  add(summary, sum_);
  const bool each = !status_.on_terminal() || detail_ == Verbosity::verbose;
  if (detail_ != Verbosity::quiet && (each || !error.empty())) {
    status_.print(
        fmt::format("[{}/{}] {}: {}", sum_.demonstrations, total_, demonstration,
                    error.empty() ? count_with_noun(summary.movements, "movement") : error));
  }
  show(sum_.demonstrations == total_);
}

void Progress::line(const std::string& text) { status_.print(text); }

void Progress::announce_stop() {
  status_.print(
      "finishing the demonstrations in progress; interrupt again to stop now (finished ones are "
      "kept)");
  const std::lock_guard lock(mutex_);
  stopping_ = true;
}

BatchSummary Progress::current_summary() const {
  const std::lock_guard lock(mutex_);
  return sum_;
}

void Progress::show(bool now) {
  constexpr std::chrono::milliseconds kMinUpdateInterval{100};
  if (detail_ == Verbosity::quiet || !status_.on_terminal()) return;
  if (!now && Clock::now() - last_shown_ < kMinUpdateInterval) return;
  last_shown_ = Clock::now();
  status_.show(text());
}

std::string Progress::text() const {
  constexpr double kLongRunning_s = 3;
  RunWorkload work = work_;
  std::string longest;
  double longest_s = 0;
  for (const auto& [name, begun] : running_) {
    work.ages_s.push_back(seconds_since(begun));
    if (work.ages_s.back() <= longest_s) continue;
    longest_s = work.ages_s.back();
    longest = name;
  }
  const std::int64_t started = sum_.reused + work.finished + std::ssize(running_);
  work.waiting = stopping_ ? 0 : std::max<std::int64_t>(0, total_ - started);
  std::string text = stopping_ ? "finishing the demonstrations in progress: " : "";
  text += progress_text(sum_, total_, work);
  if (longest_s < kLongRunning_s) return text;
  return text + fmt::format("; {} for {}", longest, duration_text(longest_s));
}

}  // namespace morphe::run
