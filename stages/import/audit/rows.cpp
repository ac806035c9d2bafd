#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/motion/count_with_noun.hpp"
#include "stages/import/audit/body_jumps.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/held_rows.hpp"

namespace morphe::imports {
namespace {

RecordingFlag flag_between(const PointStream& stream, FlagCode code, std::size_t begin,
                           std::size_t end) {
  RecordingFlag flag;
  flag.code = code;
  flag.begin_s = stream.time[begin];
  flag.end_s = stream.time[end - 1];
  return flag;
}

std::function<void(Demonstration&)> hiding(std::vector<HiddenRows> hidden) {
  return
      [hidden = std::move(hidden)](Demonstration& recording) { hide(hidden, recording.streams); };
}

Doubt block_doubt(const PointStream& stream, const RepeatedBlock& block) {
  Doubt doubt{flag_between(stream, FlagCode::repeated_rows, block.begin, block.end)};
  doubt.flag.value = static_cast<double>(block.end - block.begin);
  doubt.flag.limit = kMinBlockRows;
  doubt.flag.unit = "1";
  doubt.flag.text = fmt::format("the {} from {:.2f} s on repeat those from {:.2f} s on: hidden",
                                count_with_noun(block.end - block.begin, "row"), doubt.flag.begin_s,
                                stream.time[block.original]);
  std::vector<HiddenRows> hidden;
  for (std::size_t k = 0; k < stream.names.size(); ++k)
    hidden.push_back({stream.kind, k, block.begin, block.end});
  doubt.mend = hiding(std::move(hidden));
  return doubt;
}

/// Held rows of one point, or of all points at the same time.
struct HeldGroup {
  std::string subject;
  std::vector<HeldRows> held;
};

/// Returns true if no point that is seen in these rows moves.
bool all_points_held(const PointStream& stream, const HeldRows& held) {
  for (std::size_t i = std::max<std::size_t>(held.begin, 1); i < held.end; ++i) {
    for (std::size_t k = 0; k < stream.names.size(); ++k) {
      if ((stream.position(i, k) - stream.position(i - 1, k)).norm() > 0) return false;
    }
  }
  return stream.names.size() > 1;
}

/// Returns one group for the rows that are held in all points, and one for each other point; the
/// end of the recording is a group of its own.
std::vector<HeldGroup> groups_of(const PointStream& stream, const std::vector<HeldRows>& found) {
  std::map<std::pair<bool, std::string>, HeldGroup> groups;
  std::map<std::pair<std::size_t, std::size_t>, bool> all_held;
  for (const HeldRows& held : found) {
    const auto [known, is_new] = all_held.try_emplace({held.begin, held.end});
    if (is_new) known->second = all_points_held(stream, held);
    if (!known->second && stream.other_side[held.point]) continue;
    const std::string subject = known->second ? "" : stream.names[held.point];
    HeldGroup& group = groups[{held.at_end, subject}];
    group.subject = subject;
    group.held.push_back(held);
  }
  std::vector<HeldGroup> in_order;
  for (auto& [key, group] : groups) in_order.push_back(std::move(group));
  return in_order;
}

/// Returns the number of different rows in a group, and the length of its longest run.
std::pair<std::size_t, std::size_t> row_counts(const HeldGroup& group) {
  std::map<std::size_t, std::size_t> end_of;
  for (const HeldRows& held : group.held) end_of[held.begin] = held.end;
  std::size_t count = 0, longest = 0;
  for (const auto& [begin, end] : end_of) {
    count += end - begin;
    longest = std::max(longest, end - begin);
  }
  return {count, longest};
}

Doubt held_doubt(const PointStream& stream, const HeldGroup& group) {
  const auto [count, longest] = row_counts(group);
  std::size_t first = stream.time.size(), end = 0;
  double size_m = 0;
  std::vector<HiddenRows> hidden;
  for (const HeldRows& held : group.held) {
    first = std::min(first, held.begin);
    end = std::max(end, held.end);
    size_m = std::max(size_m, held.size_m);
    if (!group.subject.empty()) hidden.push_back({stream.kind, held.point, held.begin, held.end});
    for (std::size_t k = 0; k < stream.names.size() && group.subject.empty(); ++k)
      hidden.push_back({stream.kind, k, held.begin, held.end});
  }
  const bool repeated = group.subject.empty() && longest < kMinFrozenRows;
  Doubt doubt{
      flag_between(stream, repeated ? FlagCode::repeated_rows : FlagCode::frozen_rows, first, end)};
  doubt.flag.subject = group.subject;
  doubt.flag.value = size_m;
  doubt.flag.limit = kMinHeldJump_m;
  doubt.flag.unit = "m";
  const bool at_end = group.held.front().at_end;
  const bool added = repeated && !at_end && !(catch_up(stream, group.held) >= kMinCatchUp);
  const char* afterwards = at_end  ? "up to the end, after a step of"
                           : added ? "and then go on without catching up, by up to"
                                   : "and then jump by up to";
  const char* answer = at_end  ? ""
                       : added ? ": rows were written twice, which makes the recording slower; "
                                 "remove them, or accept repeated_rows if all times are right"
                               : ": hidden there";
  doubt.flag.text =
      fmt::format("{} exactly the same place in {} between {:.2f} and {:.2f} s, {} {:.0f} mm{}",
                  group.subject.empty() ? "all points have" : group.subject + " has",
                  count_with_noun(count, "row"), doubt.flag.begin_s, doubt.flag.end_s, afterwards,
                  kMillimetresPerMetre * size_m, answer);
  if (!at_end && !added) doubt.mend = hiding(std::move(hidden));
  return doubt;
}

/// Returns a doubt about missing rows. How many there are is an estimate from the speeds around the
/// jump, which is not certain enough to mend them.
Doubt lost_doubt(const PointStream& stream, const BodyJump& jump) {
  Doubt doubt{flag_between(stream, FlagCode::lost_rows, jump.row - 1, jump.row + 1)};
  doubt.flag.value = jump.size_m;
  doubt.flag.limit = kMinOutlier_m;
  doubt.flag.unit = "m";
  const bool counted = jump.rows_lost <= kMaxCountedRows;
  doubt.flag.text = fmt::format(
      "all points in motion jump by up to {:.0f} mm at {:.2f} s: {}rows are missing "
      "before it, or two recordings were joined",
      kMillimetresPerMetre * jump.size_m, doubt.flag.end_s,
      counted ? fmt::format("about {} ", std::lround(jump.rows_lost)) : "");
  return doubt;
}

/// Returns the doubt about rows that are missing in many places.
Doubt often_lost_doubt(const PointStream& stream, const std::vector<BodyJump>& jumps) {
  Doubt doubt{
      flag_between(stream, FlagCode::lost_rows, jumps.front().row - 1, jumps.back().row + 1)};
  doubt.flag.value = std::ranges::max(jumps, {}, &BodyJump::size_m).size_m;
  doubt.flag.limit = kMinOutlier_m;
  doubt.flag.unit = "m";
  doubt.flag.text = fmt::format(
      "all points in motion jump by up to {:.0f} mm, {} times between {:.2f} and {:.2f} s: rows "
      "are "
      "missing before each jump",
      kMillimetresPerMetre * doubt.flag.value, jumps.size(), doubt.flag.begin_s, doubt.flag.end_s);
  return doubt;
}

void add_lost_doubts(const PointStream& stream, const std::vector<BodyJump>& jumps,
                     std::vector<Doubt>& doubts) {
  if (jumps.size() > kMaxNamedJumps) {
    doubts.push_back(often_lost_doubt(stream, jumps));
    return;
  }
  for (const BodyJump& jump : jumps) doubts.push_back(lost_doubt(stream, jump));
}

/// Returns true if the jump is into or out of rows that are held or repeated.
bool is_explained(const BodyJump& jump, const std::vector<HeldRows>& held,
                  const std::vector<RepeatedBlock>& blocks) {
  return std::ranges::any_of(held, [&](const auto& h) { return h.end == jump.row; }) ||
         std::ranges::any_of(blocks, [&](const auto& block) {
           return block.begin == jump.row || block.end == jump.row;
         });
}

}  // namespace

std::vector<Doubt> check_rows(const Demonstration& recording, const AuditInput& /*input*/,
                              StepTables& tables) {
  std::vector<Doubt> doubts;
  for (const PointStream& stream : point_streams(recording)) {
    const StepTable& steps = tables.of(stream);
    const std::vector<RepeatedBlock> blocks = repeated_blocks(stream);
    const std::vector<HeldRows> held = held_rows(stream, steps);
    for (const RepeatedBlock& block : blocks) doubts.push_back(block_doubt(stream, block));
    for (const HeldGroup& group : groups_of(stream, held))
      doubts.push_back(held_doubt(stream, group));
    std::vector<BodyJump> jumps = body_jumps(stream, steps);
    std::erase_if(jumps, [&](const BodyJump& jump) { return is_explained(jump, held, blocks); });
    add_lost_doubts(stream, jumps, doubts);
  }
  return doubts;
}

}  // namespace morphe::imports
