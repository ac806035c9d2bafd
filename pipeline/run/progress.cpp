#include "pipeline/run/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace morphe::run {
namespace {

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

std::string progress_text(const BatchSummary& sum, std::int64_t total, double elapsed_s) {
  std::string text = fmt::format("{} of {}", sum.demonstrations, total);
  const double done_now = sum.demonstrations - sum.reused;
  if (done_now > 0 && elapsed_s > 0) {
    const double rate = done_now / elapsed_s;
    const double left_s = static_cast<double>(total - sum.demonstrations) / rate;
    text += rate >= 1 ? fmt::format(", {:.1f} a second", rate)
                      : fmt::format(", {:.1f} a minute", 60 * rate);
    text += fmt::format(", {} left", duration_text(left_s));
  }
  text += fmt::format(": {} executable ({} repaired), ", sum.executable, sum.repaired);
  if (sum.approximate > 0) text += fmt::format("{} approximate, ", sum.approximate);
  text += fmt::format("{} infeasible", sum.infeasible);
  return sum.failed > 0 ? text + fmt::format(", {} failed", sum.failed) : text;
}

Progress::Progress(bool quiet)
    : quiet_(quiet), terminal_(::isatty(::fileno(stderr)) == 1), begin_(Clock::now()) {}

Progress::~Progress() { clear(); }

void Progress::begin(std::int64_t total) {
  total_ = total;
  begin_ = Clock::now();
}

void Progress::reused(const BatchSummary& summary) {
  add(summary, sum_);
  ++sum_.reused;
  show(false);
}

void Progress::done(const std::string& demonstration, const BatchSummary& summary,
                    const std::string& error) {
  add(summary, sum_);
  if (!quiet_ && !terminal_) {
    fmt::print(stderr, "[{}/{}] {}: {}\n", sum_.demonstrations, total_, demonstration,
               error.empty() ? fmt::format("{} movements", summary.movements) : error);
  } else if (!quiet_ && !error.empty()) {
    line(fmt::format("{}: {}", demonstration, error));
  }
  show(sum_.demonstrations == total_);
}

void Progress::line(const std::string& text) {
  clear();
  fmt::print(stderr, "{}\n", text);
}

void Progress::show(bool now) {
  constexpr std::chrono::milliseconds kLeastPause{100};
  if (quiet_ || !terminal_ || (!now && Clock::now() - last_shown_ < kLeastPause)) return;
  last_shown_ = Clock::now();
  const double elapsed_s = std::chrono::duration<double>(last_shown_ - begin_).count();
  fmt::print(stderr, "\r\033[K{}", progress_text(sum_, total_, elapsed_s));
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (!shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace morphe::run
