#include "stages/segment/grasp_evidence.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"
#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

/// Returns 0 below `from`, 1 above `to`, and a straight line between them.
double ramp(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

struct Times {
  double begin_s = 0, end_s = 0;
};

/// Returns the range of the aperture in some intervals, without its extreme tenths.
double aperture_range(const HandSignals& signals, std::initializer_list<Times> intervals) {
  std::vector<double> values;
  for (const auto& [begin_s, end_s] : intervals) {
    if (!(end_s > begin_s)) continue;
    const auto first = signals.aperture.begin() + signals.frame(begin_s);
    values.insert(values.end(), first, signals.aperture.begin() + signals.frame(end_s) + 1);
  }
  if (values.empty()) return 0;
  const double low = math::lower_quantile(values, kTailShare);
  return math::lower_quantile(std::move(values), 1 - kTailShare) - low;
}

/// Fills in opening and closing of the hand around the end of the reach.
void weigh_fingers(const HandSignals& signals, const MovementUnit& reach, double closed_by_s,
                   GraspEvidence& evidence) {
  const int first = signals.frame(reach.begin_s), end = signals.frame(reach.end_s);
  const int closed = std::max(end, signals.frame(closed_by_s));
  const auto aperture = signals.aperture.begin();
  const auto widest = std::max_element(aperture + first, aperture + end + 1);
  const double before = aperture[first];
  const double noise = kMinApertureNoiseRatio * signals.aperture_noise;
  const double rise = *widest - before;
  const double fall = *widest - *std::min_element(widest, aperture + closed + 1);
  if (!(before > 0)) return;
  const double closes = fall > noise ? fall / std::max(rise, kSmallOpeningShare * before) : 0;
  const double opens = rise > noise ? rise / before : 0;
  evidence.opening = -1 + 2 * ramp(opens, 0, 2 * kSmallOpeningShare);
  evidence.closing = -0.5 + 1.5 * ramp(closes, 0, kClearClosingShare) +
                     ramp(fall / *widest, kSmallOpeningShare, 2 * kSmallOpeningShare);
}

/// Fills in the constancy of the aperture in `carried`, compared with the free hand before and
/// after it.
void weigh_rigidity(const HandSignals& signals, const MovementUnit& reach, const Times& carried,
                    double return_end_s, GraspEvidence& evidence) {
  const double free_m =
      aperture_range(signals, {{reach.begin_s, reach.end_s}, {carried.end_s, return_end_s}});
  const double carried_m = aperture_range(signals, {carried});
  const double noise_m = kMinApertureNoiseRatio * signals.aperture_noise + kApertureResolution_m;
  const double typical_m = signals.aperture[signals.frame(reach.end_s)];
  const double weight = free_m / (free_m + noise_m + kSmallOpeningShare * typical_m);
  const double ratio = (free_m + noise_m) / (carried_m + noise_m);
  evidence.rigidity =
      weight * std::clamp(2 * std::log(ratio / kNeutralRigidity), -kMaxFlexible, kMaxRigid);
}

/// Returns the share to which the hand is at the head: above the shoulder, and nearer to it,
/// horizontally, than half an arm's length.
double at_head(const HandRecord& hand, const MovementUnit& reach) {
  const int end = hand.signals.frame(reach.end_s);
  const bool seen = end < std::ssize(hand.motion.shoulder) && is_known(hand.motion.shoulder[end]);
  const Vec3& shoulder = seen ? hand.motion.shoulder[end] : hand.shoulder;
  if (!is_known(shoulder) || !(hand.arm_length_m > 0)) return 0;
  const Vec3 from_shoulder = (reach.end_position - shoulder) / hand.arm_length_m;
  return ramp(from_shoulder.z(), kBelowHead, kAtHead) *
         (1 - ramp(from_shoulder.head<2>().norm(), kBesideHead, kAwayFromHead));
}

}  // namespace

double GraspEvidence::log_odds() const {
  return kGraspPrior + opening + closing + rigidity + come_back + transport + head + task;
}

double GraspEvidence::probability() const { return 1 / (1 + std::exp(-log_odds())); }

GraspEvidence weigh_grasp(const HandRecord& hand, const MovementUnit& reach,
                          const std::vector<MovementUnit>& units, int next, bool comes_home,
                          const ComeBack& come_back) {
  const HandSignals& signals = hand.signals;
  GraspEvidence evidence;
  const std::ptrdiff_t count = std::ssize(units);
  const bool moves_on = next + (comes_home ? 1 : 0) < count;
  const double next_s = next < count ? units[next].begin_s : signals.end_s();
  if (!moves_on && (comes_home || signals.end_s() - reach.end_s > kLongRest_s))
    evidence.transport = kNoTransport;
  if (come_back.unit >= 0) {
    const double away = ramp(come_back.away_ratio, kNearRatio, kFarRatio);
    evidence.come_back = std::max(kNoComeBack, kComeBack * come_back.score * away);
  } else if (comes_home && moves_on) {
    evidence.come_back = kNoComeBack;
  }
  if (!signals.aperture.empty()) {
    weigh_fingers(signals, reach, std::min(next_s, reach.end_s + kLongRest_s), evidence);
    if (moves_on) {
      const bool back = come_back.unit >= 0 && come_back.score > 0;
      const double release_s = back         ? units[come_back.unit].end_s
                               : comes_home ? units.back().begin_s
                                            : units.back().end_s;
      weigh_rigidity(signals, reach, {next_s, release_s}, units.back().end_s, evidence);
    }
  }
  evidence.head = kHeadOdds * at_head(hand, reach);
  if (hand.task == TaskKind::takes_object) evidence.task = kStatedTask;
  if (hand.task == TaskKind::touches) evidence.task = -kStatedTask;
  return evidence;
}

}  // namespace morphe::segment
