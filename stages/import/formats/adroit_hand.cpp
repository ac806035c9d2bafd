// The hand is modelled on Shadow's: joint axes and offsets as in the public MuJoCo models of it
// (abduction about y, flexion about x, palm arch about (0.571, 0, 0.821); thumb: base about -z,
// proximal and hub about x, then y, y). The tests check this on the recordings.
#include "stages/import/formats/adroit_hand.hpp"

#include <numbers>

namespace morphe::imports {
namespace {

Pose turn(double angle, const Vec3& axis) { return Pose(Eigen::AngleAxisd(angle, axis)); }
Pose shift(const Vec3& offset) { return Pose(Eigen::Translation3d(offset)); }

constexpr int ARRx = 0, ARRy = 1, ARRz = 2, WRJ1 = 3, WRJ0 = 4, FFJ3 = 5, MFJ3 = 9, RFJ3 = 13,
              LFJ4 = 17, LFJ3 = 18, THJ4 = 22;

/// Returns the fingertip relative to the knuckle. Angle `first` is the abduction; three flexions
/// follow it. The phalanges are 45, 25 and 26 mm long.
Vec3 finger_tip(const AdroitAngles& q, int first) {
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  return turn(q[first], Vec3::UnitY()) * turn(q[first + 1], x) * shift(0.045 * z) *
         turn(q[first + 2], x) * shift(0.025 * z) * turn(q[first + 3], x) * Vec3(0.026 * z);
}

Vec3 thumb_tip(const AdroitAngles& q) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  return shift({0.034, -0.009, 0.029}) * turn(std::numbers::pi / 4, y) * turn(q[THJ4], -z) *
         turn(q[THJ4 + 1], x) * shift(0.038 * z) * turn(q[THJ4 + 2], x) * turn(q[THJ4 + 3], y) *
         shift(0.032 * z) * turn(q[THJ4 + 4], y) * Vec3(0.0275 * z);
}

}  // namespace

Pose adroit_world_from_palm(const AdroitAngles& q, double slide_m) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  return shift({0, -0.7, 0.2}) * turn(-1.57, x) * turn(3.14, z) * shift(slide_m * z) *
         turn(q[ARRx], x) * turn(q[ARRy], y) * turn(q[ARRz], z) * shift(0.396 * z) *
         turn(q[WRJ1], y) * shift(0.032 * z) * turn(q[WRJ0], x);
}

std::array<Vec3, 5> adroit_fingertips(const AdroitAngles& q) {
  const Vec3 arch_axis = Vec3(0.571, 0, 0.821).normalized();
  return {thumb_tip(q), shift({0.033, 0, 0.095}) * finger_tip(q, FFJ3),
          shift({0.011, 0, 0.099}) * finger_tip(q, MFJ3),
          shift({-0.011, 0, 0.095}) * finger_tip(q, RFJ3),
          shift({-0.017, 0, 0.044}) * turn(q[LFJ4], arch_axis) * shift({-0.017, 0, 0.044}) *
              finger_tip(q, LFJ3)};
}

Eigen::Matrix3d adroit_palm_from_hand() {
  Eigen::Matrix3d axes;
  axes << -Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ();
  return axes;
}

}  // namespace morphe::imports
