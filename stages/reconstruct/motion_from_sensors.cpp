#include <fmt/format.h>

#include <algorithm>

#include "pipeline/human/arm.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe {
namespace {

/// Index of a body, or nothing.
std::optional<std::size_t> find_body(const BodyStream& bodies, const std::string& name) {
  const auto found = std::find(bodies.names.begin(), bodies.names.end(), name);
  if (found == bodies.names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - bodies.names.begin());
}

template <class T>
std::vector<T> column_of(const Table<T>& table, std::size_t column) {
  std::vector<T> values;
  for (std::size_t i = 0; i < table.rows; ++i) values.push_back(table(i, column));
  return values;
}

ArmLengths lengths_of(const Demonstration& demonstration, const HumanOptions& human) {
  ArmLengths lengths = arm_lengths_of_stature(human.stature_m);
  if (human.upper_arm) lengths.upper_arm = *human.upper_arm;
  if (human.forearm) lengths.forearm = *human.forearm;
  if (demonstration.upper_arm) lengths.upper_arm = *demonstration.upper_arm;
  if (demonstration.forearm) lengths.forearm = *demonstration.forearm;
  return lengths;
}

void estimate_shoulder(const ArmLengths& lengths, const HumanOptions& human, HumanMotion& motion) {
  const auto first = std::find_if(motion.wrist.begin(), motion.wrist.end(),
                                  [](const Vec3& point) { return seen(point); });
  if (first == motion.wrist.end()) return;
  const double reach = human.reach_share * (lengths.upper_arm + lengths.forearm);
  const Vec3 wanted = *first + human.shoulder_from_first_wrist;
  const std::optional<Vec3> shoulder = shoulder_within_reach(wanted, motion.wrist, reach);
  if (!shoulder) {
    motion.problems.push_back(fmt::format(
        "no fixed shoulder has every wrist position within {:.3f} m: none is estimated", reach));
    return;
  }
  std::fill(motion.shoulder.begin(), motion.shoulder.end(), *shoulder);
  motion.estimated.push_back("shoulder");
}

void estimate_elbow(const ArmLengths& lengths, const HumanOptions& human, HumanMotion& motion) {
  for (std::size_t i = 0; i < motion.elbow.size(); ++i) {
    motion.elbow[i] =
        natural_elbow(motion.shoulder[i], motion.wrist[i], lengths, human.elbow_outward);
  }
  motion.estimated.push_back("elbow");
}

}  // namespace

HumanMotion motion_from_sensors(const Demonstration& demonstration,
                                const ReconstructOptions& options, const HumanOptions& human) {
  const BodyStream& sensors = *demonstration.streams.sensors;
  const std::optional<HandStream>& hand = demonstration.streams.hand;
  std::vector<const std::vector<double>*> times = {&sensors.time};
  if (hand) times.push_back(&hand->time);
  const Clock clock = clock_over(times, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);

  const auto shoulder = find_body(sensors, "shoulder"), elbow = find_body(sensors, "elbow");
  const auto wrist = find_body(sensors, "wrist");
  const auto position = [&](std::size_t body) {
    return on_clock(sensors.time, column_of(sensors.position, body), clock, options);
  };
  if (wrist) {
    motion.wrist = position(*wrist);
    motion.wrist_orientation =
        on_clock(sensors.time, column_of(sensors.orientation, *wrist), clock, options);
  } else {
    motion.problems.push_back("no body called wrist is tracked");
  }
  const ArmLengths lengths = lengths_of(demonstration, human);
  if (shoulder) {
    motion.shoulder = position(*shoulder);
  } else {
    estimate_shoulder(lengths, human, motion);
  }
  if (elbow) {
    motion.elbow = position(*elbow);
  } else {
    estimate_elbow(lengths, human, motion);
  }
  if (hand && hand->kind == HandKind::fingertips) {
    for (std::size_t finger = 0; finger < kFingers; ++finger) {
      const auto tip = on_clock(hand->time, column_of(hand->position, finger), clock, options);
      for (std::size_t i = 0; i < tip.size(); ++i) motion.tip(i, finger) = tip[i];
    }
  } else {
    motion.problems.push_back("no fingertips were recorded");
  }
  return motion;
}

}  // namespace morphe
