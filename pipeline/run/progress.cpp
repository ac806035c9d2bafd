#include "pipeline/run/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/motion/counted.hpp"

namespace morphe::run {
namespace {

double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

}  // namespace

std::string progress_text(const BatchSummary& sum, std::int64_t total, const WorkSoFar& work) {
  std::string text = fmt::format("{} of {}", sum.demonstrations, total);
  const double each_s = seconds_each(work);
  if (std::isfinite(each_s) && each_s > 0) {
    const double rate = work.jobs / each_s;
    text += rate >= 1 ? fmt::format(", {:.1f} a second", rate)
                      : fmt::format(", {:.1f} a minute", 60 * rate);
    text += fmt::format(", {} left", duration_text(time_left_s(work)));
  }
  text += fmt::format(": {} executable ({} repaired), ", sum.executable, sum.repaired);
  if (sum.approximate > 0) text += fmt::format("{} approximate, ", sum.approximate);
  text += fmt::format("{} infeasible", sum.infeasible);
  return sum.failed > 0 ? text + fmt::format(", {} failed", sum.failed) : text;
}

Progress::Progress(Detail detail) : detail_(detail) {
  if (detail_ == Detail::nothing || !status_.on_terminal()) return;
  ticking_ = std::thread([this] {
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::seconds(1), [this] { return end_; })) show(true);
  });
}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  if (ticking_.joinable()) ticking_.join();
}

void Progress::begin(std::int64_t total, int jobs) {
  const std::lock_guard lock(mutex_);
  total_ = total;
  work_.jobs = jobs;
  show(true);
}

void Progress::takes_in_hand(const std::string& demonstration) {
  const std::lock_guard lock(mutex_);
  in_hand_[demonstration] = Clock::now();
}

void Progress::has_finished(const std::string& demonstration) {
  const std::lock_guard lock(mutex_);
  const auto one = in_hand_.find(demonstration);
  work_.finished_s += seconds_since(one->second);
  ++work_.finished;
  in_hand_.erase(one);
}

void Progress::reused(const BatchSummary& summary) {
  const std::lock_guard lock(mutex_);
  add(summary, sum_);
  ++sum_.reused;
  show(false);
}

void Progress::done(const std::string& demonstration, const BatchSummary& summary,
                    const std::string& error) {
  const std::lock_guard lock(mutex_);
  add(summary, sum_);
  const bool each = !status_.on_terminal() || detail_ == Detail::everything;
  if (detail_ != Detail::nothing && (each || !error.empty())) {
    status_.print(fmt::format("[{}/{}] {}: {}", sum_.demonstrations, total_, demonstration,
                              error.empty() ? counted(summary.movements, "movement") : error));
  }
  show(sum_.demonstrations == total_);
}

void Progress::line(const std::string& text) { status_.print(text); }

void Progress::stopping() {
  status_.print("finishing what is in hand; again to stop now (what is finished is kept)");
  const std::lock_guard lock(mutex_);
  stopping_ = true;
}

BatchSummary Progress::so_far() const {
  const std::lock_guard lock(mutex_);
  return sum_;
}

void Progress::show(bool now) {
  constexpr std::chrono::milliseconds kLeastPause{100};
  if (detail_ == Detail::nothing || !status_.on_terminal()) return;
  if (!now && Clock::now() - last_shown_ < kLeastPause) return;
  last_shown_ = Clock::now();
  status_.show(text());
}

std::string Progress::text() const {
  constexpr double kLong_s = 3;
  WorkSoFar work = work_;
  std::string longest;
  double longest_s = 0;
  for (const auto& [name, begun] : in_hand_) {
    work.ages_s.push_back(seconds_since(begun));
    if (work.ages_s.back() <= longest_s) continue;
    longest_s = work.ages_s.back();
    longest = name;
  }
  const auto in_hand = static_cast<std::int64_t>(in_hand_.size());
  work.waiting =
      stopping_ ? 0 : std::max<std::int64_t>(0, total_ - sum_.reused - work.finished - in_hand);
  std::string text = stopping_ ? "finishing what is in hand: " : "";
  text += progress_text(sum_, total_, work);
  if (longest_s < kLong_s) return text;
  return text + fmt::format("; {} for {}", longest, duration_text(longest_s));
}

}  // namespace morphe::run
