#include "pipeline/commands/branch_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/motion/count_with_noun.hpp"
#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {
namespace {

constexpr std::size_t kMaxNamedPlans = 8;  ///< of a branch; more fit no line

/// Returns the part of a word of a branch, "shoulder" of "shoulder left", or the joint's name.
std::string part_of(const std::string& word) { return word.substr(0, word.find(' ')); }

std::string value_of(const std::string& word) { return word.substr(part_of(word).size() + 1); }

std::vector<std::string> words_only_in(const ArmBranch& branch, const ArmBranch& other) {
  std::vector<std::string> words;
  for (const std::string& word : branch.words)
    if (std::ranges::find(other.words, word) == other.words.end()) words.push_back(word);
  return words;
}

std::string names_text(const std::string& phrase, const std::vector<PlanRow>& rows) {
  std::vector<std::string> names;
  for (const PlanRow& row : rows)
    if (branch_phrase(row.branch) == phrase) names.push_back(row.name);
  if (names.empty()) return "";
  const std::size_t hidden = names.size() - std::min(names.size(), kMaxNamedPlans);
  names.resize(names.size() - hidden);
  return fmt::format(": {}{}", fmt::join(names, ", "),
                     hidden > 0 ? fmt::format(" and {} more", hidden) : "");
}

/// Returns the branches with the number of their plans, the most frequent first.
std::vector<std::pair<std::string, int>> by_frequency(const std::map<std::string, int>& counts) {
  std::vector<std::pair<std::string, int>> branches(counts.begin(), counts.end());
  std::ranges::stable_sort(branches, std::ranges::greater{}, &std::pair<std::string, int>::second);
  return branches;
}

/// Returns the branch whose phrase this is, without its number and its changes.
ArmBranch branch_of_phrase(const std::string& phrase) {
  ArmBranch branch;
  branch.number = 0;
  for (std::size_t begin = 0; begin < phrase.size();) {
    const std::size_t end = std::min(phrase.find(", ", begin), phrase.size());
    branch.words.push_back(phrase.substr(begin, end - begin));
    begin = end + 2;
  }
  return branch;
}

}  // namespace

std::string branch_phrase(const ArmBranch& branch) {
  return fmt::format("{}", fmt::join(branch.words, ", "));
}

std::string branches_text(const std::string& robot, const std::map<std::string, int>& counts,
                          const std::vector<PlanRow>& rows, std::size_t width) {
  if (counts.empty()) return "";
  if (counts.size() == 1) {
    const auto& [phrase, plans] = *counts.begin();
    return wrap_line(
        fmt::format("{}: {} in one branch ({})", robot, count_with_noun(plans, "plan"), phrase),
        width, "");
  }
  const std::vector<std::pair<std::string, int>> branches = by_frequency(counts);
  std::string text =
      wrap_line(fmt::format("{}: the plans are in {} branches", robot, branches.size()), width, "");
  for (const auto& [phrase, plans] : branches)
    text +=
        wrap_line(fmt::format("{} in {}{}", plans, phrase, names_text(phrase, rows)), width, "  ");
  return text;
}

void note_other_branches(const std::map<std::string, int>& counts, std::vector<PlanRow>& rows) {
  const std::vector<std::pair<std::string, int>> branches = by_frequency(counts);
  if (branches.size() < 2 || branches[0].second == branches[1].second) return;
  const auto& [phrase, most] = branches.front();
  const ArmBranch common = branch_of_phrase(phrase);
  int plans = 0;
  for (const auto& [unused, count] : branches) plans += count;
  for (PlanRow& row : rows) {
    const std::string change = branch_change(common, row.branch);
    if (!change.empty())
      row.lines.push_back(
          fmt::format("branch: {}, unlike {} of {}", change, most, count_with_noun(plans, "plan")));
  }
}

std::string branch_change(const ArmBranch& first, const ArmBranch& second) {
  if (!first.number || !second.number) return "";
  const std::vector<std::string> before = words_only_in(first, second);
  std::vector<std::string> after = words_only_in(second, first), changes;
  for (const std::string& word : before) {
    const auto same_part = [&](const std::string& other) {
      return part_of(other) == part_of(word);
    };
    const auto found = std::ranges::find_if(after, same_part);
    if (found == after.end()) {
      changes.push_back("no longer " + word);
    } else {
      changes.push_back(fmt::format("{} -> {}", word, value_of(*found)));
      after.erase(found);
    }
  }
  for (const std::string& word : after) changes.push_back("now " + word);
  return fmt::format("{}", fmt::join(changes, ", "));
}

}  // namespace morphe::commands
