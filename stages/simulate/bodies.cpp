#include "stages/simulate/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/rotation.hpp"

namespace morphe::simulate {
namespace {

constexpr double kLightest_kg = 0.001, kSmallest = 1e-6;  ///< [kg], [kg m^2]

/// Of a round body along z, by its moments across and about its axis.
Eigen::Matrix3d round(double across, double about) {
  return Vec3(across, across, about).asDiagonal();
}

/// Mass per density and inertia per density of a capsule along z: a cylinder and two half balls.
Inertia unit_capsule(double radius, double length) {
  const double r2 = radius * radius, l2 = length * length;
  const double tube = std::numbers::pi * r2 * length;
  const double ball = 4.0 / 3 * std::numbers::pi * r2 * radius;
  Inertia body;
  body.mass = tube + ball;
  body.about_centre =
      round(tube * (l2 / 12 + r2 / 4) + ball * (0.4 * r2 + l2 / 4 + 0.375 * length * radius),
            tube * r2 / 2 + ball * 0.4 * r2);
  return body;
}

/// Steiner's theorem.
Eigen::Matrix3d moved(double mass, const Vec3& by) {
  return mass * (by.squaredNorm() * Eigen::Matrix3d::Identity() - by * by.transpose());
}

Eigen::Matrix3d box_inertia(double mass, const Vec3& size) {
  const Vec3 squared = size.cwiseAbs2();
  const Vec3 moments(squared.y() + squared.z(), squared.z() + squared.x(),
                     squared.x() + squared.y());
  return (mass / 12 * moments).asDiagonal();
}

Inertia sum_of(const std::vector<Inertia>& parts) {
  Inertia sum;
  for (const Inertia& part : parts) {
    sum.mass += part.mass;
    sum.centre += part.mass * part.centre;
  }
  sum.centre /= sum.mass;
  for (const Inertia& part : parts)
    sum.about_centre += part.about_centre + moved(part.mass, part.centre - sum.centre);
  return sum;
}

}  // namespace

std::vector<Inertia> robot_inertias(const RobotTable& robot, double density) {
  std::vector<Inertia> links;
  for (std::size_t f = 0; f < robot.frames.size(); ++f) {
    std::vector<Inertia> parts;
    for (const RobotTable::Capsule& capsule : robot.capsules) {
      if (capsule.frame != static_cast<int>(f)) continue;
      const Vec3 along = capsule.to - capsule.from;
      Inertia part = unit_capsule(capsule.radius, along.norm());
      const Eigen::Matrix3d turn =
          math::shortest_rotation(Vec3::UnitZ(), along.norm() > 0 ? along : Vec3::UnitZ()).matrix();
      part.mass *= density;
      part.about_centre = density * turn * part.about_centre * turn.transpose();
      part.centre = 0.5 * (capsule.from + capsule.to);
      parts.push_back(part);
    }
    Inertia link;
    if (!parts.empty()) link = sum_of(parts);
    if (link.mass < kLightest_kg) {
      link.mass = kLightest_kg;
      link.about_centre = kSmallest * Eigen::Matrix3d::Identity();
    }
    links.push_back(link);
  }
  return links;
}

Inertia target_inertia(const SceneObject& object, double mass_kg) {
  Inertia body;
  body.mass = mass_kg;
  const std::vector<double>& size = object.size;
  switch (object.shape) {
    case Shape::sphere:
      body.about_centre = 0.4 * mass_kg * size[0] * size[0] * Eigen::Matrix3d::Identity();
      break;
    case Shape::box:
      body.about_centre = box_inertia(mass_kg, Vec3(size[0], size[1], size[2]));
      break;
    case Shape::cylinder: {
      const double r2 = size[0] * size[0];
      body.about_centre = mass_kg * round(size[1] * size[1] / 12 + r2 / 4, r2 / 2);
      break;
    }
    case Shape::capsule: {
      const Inertia unit = unit_capsule(size[0], size[1]);
      body.about_centre = mass_kg / unit.mass * unit.about_centre;
      break;
    }
    case Shape::mesh: {
      Eigen::AlignedBox3d box;
      for (const Vec3& vertex : object.vertices) box.extend(vertex);
      body.centre = box.center();
      body.about_centre = box_inertia(mass_kg, box.sizes());
      break;
    }
  }
  return body;
}

double lowest(const SceneObject& object, const Pose& pose, const Vec3& up) {
  const Vec3 d = pose.linear().transpose() * up;  // in the object's frame
  const std::vector<double>& size = object.size;
  double reach = 0;  // below its centre
  switch (object.shape) {
    case Shape::sphere:
      reach = size[0];
      break;
    case Shape::box:
      reach = 0.5 * d.cwiseAbs().dot(Vec3(size[0], size[1], size[2]));
      break;
    case Shape::cylinder:
      reach = size[0] * d.head<2>().norm() + 0.5 * size[1] * std::abs(d.z());
      break;
    case Shape::capsule:
      reach = size[0] + 0.5 * size[1] * std::abs(d.z());
      break;
    case Shape::mesh:
      reach = -kInfinity;
      for (const Vec3& vertex : object.vertices) reach = std::max(reach, -d.dot(vertex));
      break;
  }
  return up.dot(pose.translation()) - reach;
}

}  // namespace morphe::simulate
