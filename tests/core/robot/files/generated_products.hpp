#pragma once

// Tips of generated robots as products of 4 x 4 matrices, written out from what generate.hpp says
// and from the table of Buchholz's ratios.
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::robot {

using Mat4 = Eigen::Matrix4d;

/// axis: 0, 1, 2.
inline Mat4 rotation(int axis, double angle) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  Mat4 m = Mat4::Identity();
  m(i, i) = m(j, j) = std::cos(angle);
  m(i, j) = -std::sin(angle);
  m(j, i) = std::sin(angle);
  return m;
}
inline Mat4 shift(double x, double y, double z) {
  Mat4 m = Mat4::Identity();
  m.topRightCorner<3, 1>() = Vec3(x, y, z);
  return m;
}
inline double rad(double degrees) { return degrees * std::numbers::pi / 180; }

inline Mat4 arm_product(int joints, double length, const JointVector& q) {
  Mat4 m = Mat4::Identity();
  for (int k = 0; k < joints; ++k) {
    m *= rotation(k % 3, q[k]);
    if (k % 3 == 2) m *= shift(0, 0, length / (joints / 3));
  }
  return m;
}

/// across / breadth, along, proximal, middle, distal / length, splay.
struct FingerRow {
  double across, along, proximal, middle, distal, splay_deg;
};
inline constexpr std::array<FingerRow, 4> kBuchholz = {{{0.251, 0.447, 0.245, 0.143, 0.097, 0},
                                                        {0, 0.446, 0.266, 0.170, 0.108, 3},
                                                        {-0.206, 0.409, 0.244, 0.165, 0.107, 4},
                                                        {-0.402, 0.368, 0.204, 0.117, 0.093, 8}}};

/// Between two neighbours of the four.
inline FingerRow mixed(const FingerRow& a, const FingerRow& b, double t) {
  const auto mix = [t](double x, double y) { return (1 - t) * x + t * y; };
  return {mix(a.across, b.across), mix(a.along, b.along),   mix(a.proximal, b.proximal),
          mix(a.middle, b.middle), mix(a.distal, b.distal), mix(a.splay_deg, b.splay_deg)};
}

inline Mat4 finger_product(const FingerRow& f, double hl, double hb, const double* q) {
  return shift(0, f.across * hb, f.along * hl) * rotation(0, rad(f.splay_deg) - q[0]) *
         rotation(1, q[1]) * shift(0, 0, f.proximal * hl) * rotation(1, q[2]) *
         shift(0, 0, f.middle * hl) * rotation(1, q[3]) * shift(0, 0, f.distal * hl);
}

inline Mat4 thumb_product(double hl, double hb, const double* q) {
  return shift(0, 0.196 * hb, 0.073 * hl) * rotation(2, -q[0]) * rotation(0, -rad(30) - q[1]) *
         shift(0, 0, 0.251 * hl) * rotation(2, -rad(90)) * rotation(1, q[2]) *
         shift(0, 0, 0.196 * hl) * rotation(1, q[3]) * shift(0, 0, 0.158 * hl);
}

/// The hand of five fingers, its joints beginning at q[0]; by the tips' names.
inline std::map<std::string, Mat4> hand_products(double hl, double hb, const double* q) {
  std::map<std::string, Mat4> tips = {{"thumb_tip", thumb_product(hl, hb, q)}};
  const char* names[] = {"index_tip", "middle_tip", "ring_tip", "little_tip"};
  for (std::size_t k = 0; k < 4; ++k) {
    tips[names[k]] = finger_product(kBuchholz[k], hl, hb, q + 4 * (k + 1));
  }
  return tips;
}

}  // namespace morphe::robot
