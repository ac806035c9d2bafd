#include "stages/segment/segment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "stages/segment/bouts.hpp"
#include "stages/segment/grasp.hpp"

namespace morphe {
namespace {

double share_seen(const HandSignals& signals, double begin_s, double end_s) {
  const std::size_t first = signals.frame(begin_s), last = signals.frame(end_s);
  std::size_t count = 0;
  for (std::size_t i = first; i <= last; ++i) count += signals.seen[i] ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(last - first + 1);
}

double farthest(const HandSignals& signals, const Bout& bout, const Vec3& from) {
  double distance = 0;
  for (std::size_t i = bout.first; i <= bout.last; ++i) {
    distance = std::max(distance, (signals.position[i] - from).norm());
  }
  return distance;
}

/// Number of bouts from `begin` on that form one cycle, the last one coming home if any does; 0 if
/// the first one is no reach: it stays near its start, comes back at once, or the recording begins
/// after its peak.
std::size_t cycle_length(const HandSignals& signals, const SegmentOptions& options,
                         const std::vector<Bout>& bouts, std::size_t begin, bool& comes_home) {
  const Bout& reach = bouts[begin];
  const Vec3 start = signals.position[signals.frame(reach.begin_s)];
  const auto from_start = [&](const Bout& bout) {
    return (signals.position[signals.frame(bout.end_s)] - start).norm();
  };
  const double extent = farthest(signals, reach, start);
  const double home = std::min(options.home_radius, 0.5 * extent);
  comes_home = false;
  if (extent < options.least_reach || from_start(reach) < home) return 0;
  if (reach.cut && reach.peak <= reach.first + 2) return 0;
  for (std::size_t k = begin + 1; k < bouts.size(); ++k) {
    if (from_start(bouts[k]) < home) {
      comes_home = true;
      return k - begin + 1;
    }
  }
  return bouts.size() - begin;
}

/// Number of bouts at the head of a recording that begins inside a reach, after its peak: with the
/// start unseen they are one cycle, up to the first that ends where the hand finally rests. Without
/// it the way to the mouth would pass for a reach. 1 if the first bout is no such reach, which is
/// one that leads away from the shoulder, or the recording does not end at rest.
std::size_t headless_cycle(const HumanMotion& motion, const HandSignals& signals,
                           const SegmentOptions& options, const std::vector<Bout>& bouts) {
  const Bout& reach = bouts.front();
  const auto shoulder = std::find_if(motion.shoulder.begin(), motion.shoulder.end(),
                                     [](const Vec3& point) { return seen(point); });
  if (!reach.cut || shoulder == motion.shoulder.end()) return 1;
  if (bouts.back().last + 1 >= signals.frames()) return 1;
  const auto away = [&](double time_s) {
    return (signals.position[signals.frame(time_s)] - *shoulder).norm();
  };
  if (away(reach.end_s) <= away(reach.begin_s)) return 1;
  const Vec3 home = signals.position.back();
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const Vec3 end = signals.position[signals.frame(bouts[k].end_s)];
    if ((end - home).norm() < 0.5 * options.home_radius) return k + 1;
  }
  return 1;
}

void add_phase(const HandSignals& signals, const char* name, double begin_s, double end_s,
               double begin_confidence, double end_confidence, Movement& movement) {
  if (end_s - begin_s < 0.5 * signals.step_s) return;
  const double seen = share_seen(signals, begin_s, end_s);
  movement.phases.push_back(
      {name, begin_s, end_s, 0.5 * (begin_confidence + end_confidence) * seen});
}

const Phase* last_phase(const Movement& movement, const std::string& name) {
  const Phase* found = nullptr;
  for (const Phase& phase : movement.phases) {
    if (phase.name == name) found = &phase;
  }
  return found;
}

void choose_what_is_planned(const SegmentOptions& options, Movement& movement) {
  const Phase& reach = movement.phases.front();
  movement.begin_s = reach.begin_s;
  const Phase* until = last_phase(movement, options.plan_until);
  if (!until) until = last_phase(movement, "grasp");
  if (until) {
    movement.end_s = until->end_s;
    return;
  }
  movement.end_s = reach.end_s;
  for (const Phase& phase : movement.phases) {
    if (phase.name != "hold" || phase.begin_s > reach.end_s + 1e-9) continue;
    movement.end_s = std::min(phase.end_s, reach.end_s + options.touch_hold);
  }
}

/// Bouts after the reach (and its grasp), with the pauses between them.
void add_later_phases(const HandSignals& signals, const std::vector<Bout>& bouts, bool comes_home,
                      bool carries, double from_s, double from_confidence, Movement& movement) {
  for (std::size_t k = 0; k < bouts.size(); ++k) {
    const Bout& bout = bouts[k];
    if (bout.end_s <= from_s) continue;
    add_phase(signals, "hold", from_s, bout.begin_s, from_confidence, bout.begin_confidence,
              movement);
    const bool home = comes_home && k + 1 == bouts.size();
    add_phase(signals,
              home      ? "return"
              : carries ? "transport"
                        : "reach",
              std::max(from_s, bout.begin_s), bout.end_s, bout.begin_confidence,
              bout.end_confidence, movement);
    from_s = bout.end_s;
    from_confidence = bout.end_confidence;
  }
  if (!comes_home) {
    add_phase(signals, "hold", from_s, signals.time(static_cast<double>(signals.frames() - 1)),
              from_confidence, from_confidence, movement);
  }
}

Movement make_movement(const HandSignals& signals, const SegmentOptions& options,
                       const std::vector<SceneObject>& objects, std::vector<Bout> bouts,
                       bool comes_home) {
  Movement movement;
  const GraspTimes grasp = find_grasp(signals, options, objects, bouts);
  movement.target = grasp.object;
  const Bout& reach = bouts.front();
  add_phase(signals, "reach", reach.begin_s, grasp.begin_s, reach.begin_confidence,
            grasp.begin_confidence, movement);
  const bool has_reach = !movement.phases.empty();
  if (grasp.found && has_reach) {
    const double begin_s = std::clamp(grasp.preshape_s, reach.begin_s, grasp.begin_s);
    add_phase(signals, "preshape", begin_s, grasp.begin_s, grasp.opening_confidence,
              grasp.begin_confidence, movement);
    add_phase(signals, "grasp", grasp.begin_s, grasp.end_s, grasp.begin_confidence,
              grasp.end_confidence, movement);
  }
  bouts.erase(bouts.begin(), bouts.begin() + static_cast<std::ptrdiff_t>(grasp.bouts_used));
  if (grasp.found && !bouts.empty()) {
    bouts.front().begin_s = grasp.end_s;
    bouts.front().begin_confidence = grasp.end_confidence;
  }
  add_later_phases(signals, bouts, comes_home && !bouts.empty(), grasp.found, grasp.end_s,
                   grasp.end_confidence, movement);
  if (!has_reach) movement.phases.clear();
  return movement;
}

}  // namespace

std::string check(const SegmentOptions& o) {
  const std::pair<const char*, double> shares[] = {
      {"stop_share", o.stop_share},         {"onset_share", o.onset_share},
      {"weak_share", o.weak_share},         {"dip_share", o.dip_share},
      {"widening_share", o.widening_share}, {"closing_share", o.closing_share},
      {"preshape_share", o.preshape_share}};
  for (const auto& [name, value] : shares) {
    if (value < 0 || value >= 1) return fmt::format("{}: must be in [0, 1), not {}", name, value);
  }
  const std::pair<const char*, double> lengths[] = {
      {"smoothing", o.smoothing},     {"least_peak", o.least_peak},
      {"least_reach", o.least_reach}, {"home_radius", o.home_radius},
      {"least_grasp", o.least_grasp}, {"object_motion", o.object_motion},
      {"touch_hold", o.touch_hold}};
  for (const auto& [name, value] : lengths) {
    if (value < 0) return fmt::format("{}: must not be negative, not {}", name, value);
  }
  if (o.stop_share == 0) return "stop_share: must be above 0";
  if (o.dip_share == 0) return "dip_share: must be above 0";
  if (o.least_peak == 0) return "least_peak: must be above 0";
  if (o.plan_until != "grasp" && o.plan_until != "transport" && o.plan_until != "return") {
    return fmt::format("plan_until: must be grasp, transport or return, not '{}'", o.plan_until);
  }
  return "";
}

std::vector<Movement> segment(const HumanMotion& motion, const SegmentOptions& options,
                              const std::vector<SceneObject>& objects) {
  const HandSignals signals = hand_signals(motion, options.smoothing);
  const std::vector<Bout> bouts = find_bouts(signals, options);
  std::vector<Movement> movements;
  for (std::size_t i = 0; i < bouts.size();) {
    bool comes_home = false;
    std::size_t count = cycle_length(signals, options, bouts, i, comes_home);
    if (count > 0) {
      const auto begin = bouts.begin() + static_cast<std::ptrdiff_t>(i);
      Movement movement =
          make_movement(signals, options, objects,
                        {begin, begin + static_cast<std::ptrdiff_t>(count)}, comes_home);
      if (!movement.phases.empty()) {
        movement.index = static_cast<int>(movements.size());
        choose_what_is_planned(options, movement);
        movements.push_back(std::move(movement));
      }
    }
    if (count == 0) count = i == 0 ? headless_cycle(motion, signals, options, bouts) : 1;
    i += count;
  }
  return movements;
}

}  // namespace morphe
