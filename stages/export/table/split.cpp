#include "stages/export/table/split.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "core/math/seed.hpp"

namespace morphe::exports {
namespace {

/// Returns a number in [0, 1) that is the same everywhere for a key.
double uniform_hash(const std::string& key) {
  constexpr std::uint64_t kSplitSeed = 0;
  return std::ldexp(static_cast<double>(math::seed_from(kSplitSeed, "split/" + key) >> 11), -53);
}

}  // namespace

std::string split_key(const Plan& plan, SplitBy by) {
  const bool person = by == SplitBy::person && !plan.subject.empty();
  return person ? "person/" + plan.subject : "demonstration/" + plan.demonstration;
}

std::vector<std::string_view> split_sides(const std::vector<std::string>& keys,
                                          double validation_share) {
  std::set<std::pair<double, std::string>> ordered;
  for (const std::string& key : keys) ordered.emplace(uniform_hash(key), key);
  std::set<std::string> valid;
  for (const auto& [hash, key] : ordered)
    if (hash < validation_share) valid.insert(key);
  if (ordered.size() > 1 && valid.empty()) valid.insert(ordered.begin()->second);
  if (!valid.empty() && valid.size() == ordered.size()) valid.erase(ordered.rbegin()->second);
  std::vector<std::string_view> sides;
  for (const std::string& key : keys) sides.push_back(valid.contains(key) ? kValid : kTrain);
  return sides;
}

}  // namespace morphe::exports
