#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/closure/contact.hpp"
#include "core/math/random_stream.hpp"

namespace morphe::closure {

/// Contacts press towards the inside at p, in units of the torque scale.
inline ContactSet unit_set(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                           double mu, double g) {
  ContactSet set;
  for (std::size_t k = 0; k < points.size(); ++k) set.contacts.push_back({points[k], normals[k]});
  set.friction = {mu, g};
  return set;
}

/// On the unit sphere.
inline ContactSet sphere_set(std::vector<Vec3> points, double mu, double g) {
  std::vector<Vec3> normals;
  for (Vec3& point : points) {
    point.normalize();
    normals.push_back(-point);
  }
  return unit_set(points, normals, mu, g);
}

/// Two opposite fingers, each `l` from the centre.
inline ContactSet two_fingers(double l, double mu, double g) {
  return unit_set({{0, 0, l}, {0, 0, -l}}, {{0, 0, -1}, {0, 0, 1}}, mu, g);
}

/// Three at 120 degrees around a unit disc.
inline ContactSet three_fingers(double mu, double g) {
  const double s = std::sqrt(0.75);
  return sphere_set({{1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}}, mu, g);
}

inline ContactSet tetrahedron(double mu) {
  return sphere_set({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, mu, 0);
}

inline ContactSet octahedron(double mu) {
  return sphere_set({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, mu, 0);
}

/// Epsilon by a closed form, or numbers that were computed elsewhere.
struct ClosedForm {
  std::string name;
  ContactSet set;
  double sum, each;  ///< of L1 and of L∞; NaN: not known
};

inline std::vector<ClosedForm> closed_forms() {
  std::vector<ClosedForm> forms;
  for (const auto& [l, mu, g] : {std::array{1.0, 0.6, 0.3}, std::array{1.0, 0.6, 1.0},
                                 std::array{1.0, 0.8, 0.57}, std::array{0.5, 0.6, 0.3}}) {
    const double square = 1 + 1 / (l * l);
    forms.push_back(
        {"two opposite", two_fingers(l, mu, g), std::min(g, mu / std::sqrt(square + mu * mu)),
         std::min(2 * g / std::sqrt(1 + g * g), 2 * mu / std::sqrt(square + 4 * mu * mu))});
  }
  forms.push_back({"three, mu 0.2", three_fingers(0.2, 0), 0.105272, 0.6 / std::sqrt(5)});
  forms.push_back({"three, mu 0.4", three_fingers(0.4, 0), 0.226744, kUnknown});
  forms.push_back({"three, mu 0.5", three_fingers(0.5, 0), 0.287698, kUnknown});
  forms.push_back({"three, mu 0.8", three_fingers(0.8, 0), 0.8 / std::sqrt(3), 2.4 / std::sqrt(5)});
  forms.push_back({"three soft, mu 0.2", three_fingers(0.2, 0.05), 0.118676, kUnknown});
  forms.push_back({"three soft, mu 0.5", three_fingers(0.5, 0.05), 0.300440, kUnknown});
  forms.push_back({"three soft, mu 0.8", three_fingers(0.8, 0.05), 0.477155, kUnknown});
  forms.push_back({"tetrahedron", tetrahedron(0.5), 0.5 / std::sqrt(2), kUnknown});
  forms.push_back({"octahedron", octahedron(0.5), 0.5 * std::sqrt(2.0 / 3), 2});
  return forms;
}

/// Anywhere on an ellipsoid with half axes of 18 to 60 mm; mu 0.3 to 1.
inline ContactSet random_grasp(math::RandomStream& random, int contacts, double gamma_m) {
  const Vec3 axes(0.06, random.uniform(0.018, 0.06), random.uniform(0.018, 0.06));
  ContactSet set;
  set.friction = {random.uniform(0.3, 1), gamma_m};
  set.torque_scale_m = 0.06;
  for (int k = 0; k < contacts; ++k) {
    const Vec3 direction = random.normal_vector3().normalized();
    set.contacts.push_back(
        {axes.cwiseProduct(direction), -direction.cwiseQuotient(axes).normalized()});
  }
  return set;
}

/// The same grasp, turned about c and moved.
inline ContactSet moved(const ContactSet& set, const Quat& turn, const Vec3& shift) {
  ContactSet made = set;
  made.reference = turn * set.reference + shift;
  for (Contact& contact : made.contacts) {
    contact.point = turn * contact.point + shift;
    contact.normal = turn * contact.normal;
  }
  return made;
}

/// On the faces of a cube, at multiples of half its half side, some contacts twice: sets full of
/// coplanar points, with 0 on a border more often than not.
inline ContactSet cube_grasp(math::RandomStream& random, int contacts, double mu, double g) {
  std::vector<Vec3> points, normals;
  for (int k = 0; k < contacts; ++k) {
    const int axis = random.uniform_integer({0, 2});
    Vec3 point, normal = Vec3::Zero();
    for (int j = 0; j < 3; ++j) point[j] = 0.5 * random.uniform_integer({-2, 2});
    point[axis] = random.bernoulli(0.5) ? 1 : -1;
    normal[axis] = -point[axis];
    for (int times = random.bernoulli(0.1) ? 2 : 1; times > 0; --times) {
      points.push_back(point);
      normals.push_back(normal);
    }
  }
  return unit_set(points, normals, mu, g);
}

/// A grasp anywhere in space that holds 0 in a flat set, or `off` from flat: two to five contacts
/// on a line, two opposite fingers (off: in their torsion), a sphere (off: in its friction).
inline ContactSet flat_grasp(math::RandomStream& random, int kind, double off) {
  ContactSet set = two_fingers(random.uniform(0.3, 1), random.uniform(0.3, 1), 0);
  if (kind % 3 == 0) {
    for (int k = kind / 3 % 4; k > 0; --k) {
      const Vec3 normal = random.normal_vector3().normalized();
      set.contacts.push_back({{off, 0, random.uniform(-1, 1)}, normal});
    }
    set.contacts[0].point.x() = off;
  } else if (kind % 3 == 1) {
    set.friction.gamma_m = off;
  } else {
    std::vector<Vec3> points;
    for (int k = 0; k < 5; ++k) points.push_back(random.normal_vector3());
    points.push_back(-points[0] - points[1] - points[2]);
    set = sphere_set(points, off, 0);
  }
  return moved(set, random.rotation(), random.normal_vector3());
}

}  // namespace morphe::closure
