#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/motion/count_with_noun.hpp"
#include "stages/import/audit/body_jumps.hpp"
#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/point_jumps.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// Returns true if the reconstruction's low-pass leaves too little of a spike to matter. The
/// robot's fingertips follow those of the person; other points act on the joints, and together.
bool is_harmless(const PointStream& stream, const Excursion& spike) {
  if (!spike.returns || spike.size_m > kMaxHarmlessSpike_m) return false;
  const std::size_t last = std::min(spike.end, stream.time.size() - 1);
  const double duration_s = stream.time[last] - stream.time[spike.begin];
  const double left_m = spike.size_m * std::min(1.0, kFilterPeak * kFilter_hz * duration_s);
  const bool is_tip = body_part(stream.names[spike.point]).ends_with(" tip");
  return left_m < (is_tip ? kMinTipSpikeLeft_m : kMinSpikeLeft_m);
}

/// Excursions of one point, or of many points at the same time.
struct Group {
  std::string subject;
  std::vector<Excursion> excursions;
};

/// Divides excursions into those that many points have in common, and those of each point.
std::vector<Group> groups_of(const PointStream& stream, const std::vector<Excursion>& found) {
  std::map<std::pair<std::size_t, std::size_t>, std::ptrdiff_t> count;
  for (const Excursion& e : found) ++count[{e.begin, e.end}];
  const std::ptrdiff_t judged = std::ranges::count(stream.other_side, false);
  const std::ptrdiff_t many = std::max(kManyPoints, judged / 2);
  std::map<std::string, Group> groups;  // "" is the group of many points
  for (const Excursion& e : found) {
    const std::string subject = count[{e.begin, e.end}] >= many ? "" : stream.names[e.point];
    groups[subject].subject = subject;
    groups[subject].excursions.push_back(e);
  }
  std::vector<Group> in_order;
  for (auto& [subject, group] : groups) in_order.push_back(std::move(group));
  return in_order;
}

std::string times_of(const RecordingFlag& flag, std::size_t count) {
  return count == 1
             ? fmt::format("at {:.2f} s", flag.begin_s)
             : fmt::format("{} times between {:.2f} and {:.2f} s", count, flag.begin_s, flag.end_s);
}

/// Returns the flag of a group without its sentence.
RecordingFlag flag_of(const PointStream& stream, const Group& group) {
  RecordingFlag flag;
  flag.subject = group.subject;
  flag.value = 0;
  flag.unit = "m";
  flag.begin_s = kInfinity;
  flag.end_s = -kInfinity;
  for (const Excursion& e : group.excursions) {
    flag.value = std::max(flag.value, e.size_m);
    flag.begin_s = std::min(flag.begin_s, stream.time[e.begin]);
    // A point that steps is wrong until the end, or was until then: which is not known.
    flag.end_s = std::max(flag.end_s, e.returns ? stream.time[e.end - 1] : stream.time.back());
  }
  return flag;
}

std::size_t distinct_times(const Group& group) {
  std::map<std::size_t, int> begins;
  for (const Excursion& e : group.excursions) ++begins[e.begin];
  return begins.size();
}

Doubt spike_doubt(const PointStream& stream, const Group& group) {
  Doubt doubt{flag_of(stream, group)};
  doubt.flag.code = FlagCode::spike;
  doubt.flag.limit = kMinOutlier_m;
  std::size_t longest = 0;
  std::vector<HiddenRows> hidden;
  for (const Excursion& e : group.excursions) {
    longest = std::max(longest, e.end - e.begin);
    hidden.push_back({stream.kind, e.point, e.begin, e.end});
  }
  doubt.flag.text =
      fmt::format("{} up to {:.0f} mm away from its course for {}, {}: hidden there",
                  group.subject.empty() ? "all points are" : group.subject + " is",
                  kMillimetresPerMetre * doubt.flag.value, count_with_noun(longest, "row"),
                  times_of(doubt.flag, distinct_times(group)));
  doubt.mend = [hidden](Demonstration& recording) { hide(hidden, recording.streams); };
  return doubt;
}

Doubt step_doubt(const PointStream& stream, const Group& group) {
  Doubt doubt{flag_of(stream, group)};
  const bool all = group.subject.empty();
  doubt.flag.code = all ? FlagCode::lost_rows : FlagCode::step;
  doubt.flag.limit = kMinFarOutlier_m;
  const std::size_t count = distinct_times(group);
  doubt.flag.text =
      fmt::format("{} from one row to the next by up to {:.0f} mm, and {} away, {}",
                  all ? "many points jump" : group.subject + " jumps",
                  kMillimetresPerMetre * doubt.flag.value, all ? "stay" : "stays",
                  count == 1 ? fmt::format("at {:.2f} s", doubt.flag.begin_s)
                             : fmt::format("{} times from {:.2f} s on", count, doubt.flag.begin_s));
  return doubt;
}

}  // namespace

std::vector<Doubt> check_jumps(const Demonstration& recording, const AuditInput& /*input*/,
                               StepTables& tables) {
  std::vector<Doubt> doubts;
  for (const PointStream& stream : point_streams(recording)) {
    const StepTable& steps = tables.of(stream);
    std::vector<std::size_t> body_jump_rows;
    for (const BodyJump& jump : body_jumps(stream, steps)) body_jump_rows.push_back(jump.row);
    std::vector<Excursion> found = excursions(stream, steps, body_jump_rows), away;
    std::erase_if(found, [&](const Excursion& e) { return is_harmless(stream, e); });
    std::ranges::copy_if(found, std::back_inserter(away), [](auto& e) { return !e.returns; });
    std::erase_if(found, [](const Excursion& e) { return !e.returns; });
    for (const Group& group : groups_of(stream, found))
      doubts.push_back(spike_doubt(stream, group));
    for (const Group& group : groups_of(stream, away)) doubts.push_back(step_doubt(stream, group));
  }
  return doubts;
}

}  // namespace morphe::imports
