#include "stages/grasp/desired_contact.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::grasp {
namespace {

double smoothstep(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

}  // namespace

SurfacePoint nearest_surface(const collision::Solid& solid, const Vec3& point) {
  SurfacePoint nearest;
  Vec3 outwards;
  nearest.distance = collision::signed_distance(solid, point, outwards);
  nearest.point = point - nearest.distance * outwards;
  nearest.normal = -outwards;
  return nearest;
}

double pad_angle(const Vec3& pad_direction, const Vec3& inward_normal) {
  return std::atan2(pad_direction.cross(inward_normal).norm(), pad_direction.dot(inward_normal));
}

HoldInterval hold_interval(const Movement& movement) {
  HoldInterval interval;
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  if (!grasp || grasp->begin_s > movement.end_s) return interval;
  const Phase* hold = last_phase(movement, PhaseKind::hold);
  const Phase* preshape = last_phase(movement, PhaseKind::preshape);
  const Phase* transport = last_phase(movement, PhaseKind::transport);
  interval.begin_s = grasp->begin_s;
  interval.end_s = std::min(movement.end_s, std::max(grasp->end_s, hold ? hold->end_s : 0));
  interval.open_s = preshape && preshape->begin_s < grasp->begin_s
                        ? preshape->begin_s
                        : grasp->begin_s - kReleaseDuration_s;
  interval.release_s = transport ? transport->end_s : kInfinity;
  const HeldInterval held = held_interval(movement);
  interval.closed_s = std::isnan(held.begin_s) ? interval.begin_s : held.begin_s;
  if (!(interval.open_s < interval.closed_s))  // a preshape shorter than kSettling_s
    interval.open_s = interval.closed_s - kReleaseDuration_s;
  interval.opening_s = std::isnan(held.end_s) ? interval.release_s : held.end_s;
  return interval;
}

double closing_progress(const HoldInterval& hold, double time_s) {
  if (!(time_s > hold.open_s)) return 0;
  const double closing = smoothstep((time_s - hold.open_s) / (hold.closed_s - hold.open_s));
  return time_s <= hold.opening_s ? closing
                                  : 1 - smoothstep((time_s - hold.opening_s) / kReleaseDuration_s);
}

}  // namespace morphe::grasp
