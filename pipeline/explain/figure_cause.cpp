#include "pipeline/explain/figure_cause.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace morphe::explain {
namespace {

/// Below this a figure is small: two repetitions of one person's movement differ by 6 degrees.
constexpr double kSmallError_rad = 6 * kRadPerDegree;
/// Changes explain the wrist's offset if at most this share of it remains after them; chosen by
/// hand, so that they explain more than all else.
constexpr double kExplainedShare = 0.5;
/// Explanations that differ by less than this share of the whole are not told apart. Chosen by
/// hand: a base that was shifted and longer links differ by more for movements that turn both links
/// by 30 degrees (tests/pipeline/explain/figure_cause_test.cpp).
constexpr double kCloseShare = 0.15;

/// A cause and the amount that it accounts for.
using Account = std::pair<FigureCause, double>;

/// Returns the cause of the largest amount, and those that are close to it.
FigureCauses largest_of(std::vector<Account> accounts, double whole) {
  std::ranges::stable_sort(accounts, std::ranges::greater{}, &Account::second);
  FigureCauses causes{{accounts.front().first}, {}};
  for (std::size_t k = 1; k < accounts.size(); ++k)
    if (accounts.front().second - accounts[k].second < kCloseShare * whole)
      causes.instead.push_back(accounts[k].first);
  return causes;
}

/// The causes that the changes of the wrist's offset stand for, in the order in which they are
/// named.
constexpr std::array<std::pair<unsigned, FigureCause>, 5> kChanges{
    {{kLinksChange, FigureCause::size},
     {kFingersChange, FigureCause::robot_hand},
     {kPalmChange, FigureCause::palm_angle},
     {kTipsChange, FigureCause::tips},
     {kBaseChange, FigureCause::placement}}};

void append_causes(unsigned changes, const WristOffset& wrist, std::vector<FigureCause>& causes) {
  for (const auto& [change, cause] : kChanges) {
    if (!(changes & change)) continue;
    const bool whole_wrist = change == kFingersChange && !wrist.is_hand_known;
    causes.push_back(whole_wrist ? FigureCause::wrist_place : cause);
  }
}

/// Returns the remainder after changes, rounded, so that no last digit decides [m].
double remainder_of(unsigned changes, const WristOffset& wrist) {
  constexpr double kResolution_m = 1e-4;
  return kResolution_m * std::round(wrist.after[changes] / kResolution_m);
}

/// Returns the sums of `count` changes, the one that leaves least first.
std::vector<unsigned> sums_of(int count, const WristOffset& wrist) {
  std::vector<unsigned> sums;
  for (unsigned sum = 1; sum < kWristChangeSums; ++sum)
    if (std::popcount(sum) == count) sums.push_back(sum);
  std::ranges::stable_sort(sums, {}, [&](unsigned sum) { return remainder_of(sum, wrist); });
  return sums;
}

/// Returns the causes of the wrist's offset: the fewest changes that explain it. A base that alone
/// could be hardly better is no cause, although it would have to follow another change.
FigureCauses causes_of_wrist(const WristOffset& wrist) {
  const double whole = wrist.rms();
  if (std::isnan(whole)) return {};
  const bool base_is_best = wrist.after[kBaseChange] > (1 - kCloseShare) * whole;
  const auto without_base = [&](unsigned sum) {
    return base_is_best && sum != kBaseChange ? sum & ~kBaseChange : sum;
  };
  for (int count = 1;; ++count) {
    const std::vector<unsigned> sums = sums_of(count, wrist);
    const double least = remainder_of(sums.front(), wrist);
    if (least > kExplainedShare * whole) continue;  // all changes leave 0
    FigureCauses causes{{}, {}};
    append_causes(without_base(sums.front()), wrist, causes.all);
    for (const unsigned sum : sums)
      if (remainder_of(sum, wrist) - least < kCloseShare * whole)
        append_causes(without_base(sum), wrist, causes.instead);
    return causes;
  }
}

/// Removes causes that appear before or twice.
FigureCauses without_doubles(FigureCauses causes) {
  std::vector<FigureCause> instead;
  for (const FigureCause cause : causes.instead)
    if (std::ranges::find(causes.all, cause) == causes.all.end() &&
        std::ranges::find(instead, cause) == instead.end())
      instead.push_back(cause);
  causes.instead = std::move(instead);
  return causes;
}

}  // namespace

FigureCauses causes_of_direction(double driven, double forced, const WristOffset& wrist) {
  if (std::isnan(driven)) return {};
  if (driven < kSmallError_rad) return {{FigureCause::small}, {}};
  const FigureCauses choice = largest_of(
      {{FigureCause::weights_or_solver, driven - forced}, {FigureCause::wrist_place, forced}},
      driven);
  if (choice.all.front() == FigureCause::wrist_place) {
    FigureCauses causes = causes_of_wrist(wrist);
    causes.instead.insert(causes.instead.end(), choice.instead.begin(), choice.instead.end());
    return without_doubles(std::move(causes));
  }
  if (choice.instead.empty()) return choice;
  FigureCauses causes = causes_of_wrist(wrist);
  causes.instead.insert(causes.instead.begin(), causes.all.begin(), causes.all.end());
  causes.all = choice.all;
  return without_doubles(std::move(causes));
}

FigureCauses causes_of_palm(double driven, const PalmFloor& floor) {
  if (std::isnan(driven)) return {};
  if (driven < kSmallError_rad) return {{FigureCause::small}, {}};
  if (std::isnan(floor.driven)) return {};
  return largest_of({{FigureCause::robot_hand, floor.hand_alone},
                     {FigureCause::placement_or_size, floor.whole_robot - floor.hand_alone},
                     {FigureCause::weights_or_solver, floor.driven - floor.whole_robot}},
                    floor.driven);
}

}  // namespace morphe::explain
