#include "stages/simulate/inertias.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/rotation.hpp"

namespace morphe::simulate {
namespace {

constexpr double kMinLinkMass_kg = 0.001, kMinInertia_kg_m2 = 1e-6;

Eigen::Matrix3d axisymmetric_inertia(double across, double about) {
  return Vec3(across, across, about).asDiagonal();
}

/// Returns mass and inertia for a density of 1 of a capsule along z: a cylinder and two half balls.
Inertia unit_capsule(double radius, double length) {
  const double r2 = radius * radius, l2 = length * length;
  const double tube = std::numbers::pi * r2 * length;
  const double ball = 4.0 / 3 * std::numbers::pi * r2 * radius;
  Inertia body;
  body.mass = tube + ball;
  body.inertia_at_com = axisymmetric_inertia(
      tube * (l2 / 12 + r2 / 4) + ball * (0.4 * r2 + l2 / 4 + 0.375 * length * radius),
      tube * r2 / 2 + ball * 0.4 * r2);
  return body;
}

Eigen::Matrix3d parallel_axis_term(double mass, const Vec3& offset) {
  return mass * (offset.squaredNorm() * Eigen::Matrix3d::Identity() - offset * offset.transpose());
}

Eigen::Matrix3d box_inertia(double mass, const Vec3& size) {
  const Vec3 s2 = size.cwiseAbs2();
  const Vec3 moments(s2.y() + s2.z(), s2.z() + s2.x(), s2.x() + s2.y());
  return (mass / 12 * moments).asDiagonal();
}

Inertia combined_inertia(const std::vector<Inertia>& parts) {
  Inertia sum;
  for (const Inertia& part : parts) {
    sum.mass += part.mass;
    sum.centre_of_mass += part.mass * part.centre_of_mass;
  }
  sum.centre_of_mass /= sum.mass;
  for (const Inertia& part : parts)
    sum.inertia_at_com += part.inertia_at_com +
                          parallel_axis_term(part.mass, part.centre_of_mass - sum.centre_of_mass);
  return sum;
}

}  // namespace

std::vector<Inertia> robot_inertias(const RobotModel& robot, double density) {
  std::vector<Inertia> links;
  for (int f = 0; f < std::ssize(robot.frames); ++f) {
    std::vector<Inertia> parts;
    for (const RobotModel::Capsule& capsule : robot.capsules) {
      if (capsule.frame != f) continue;
      const Vec3 along = capsule.to - capsule.from;
      Inertia part = unit_capsule(capsule.radius, along.norm());
      const Eigen::Matrix3d rotation =
          math::shortest_rotation(Vec3::UnitZ(), along.norm() > 0 ? along : Vec3::UnitZ()).matrix();
      part.mass *= density;
      part.inertia_at_com = density * rotation * part.inertia_at_com * rotation.transpose();
      part.centre_of_mass = 0.5 * (capsule.from + capsule.to);
      parts.push_back(part);
    }
    Inertia link;
    if (!parts.empty()) link = combined_inertia(parts);
    if (link.mass < kMinLinkMass_kg) {
      link.mass = kMinLinkMass_kg;
      link.inertia_at_com = kMinInertia_kg_m2 * Eigen::Matrix3d::Identity();
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
      body.inertia_at_com = 0.4 * mass_kg * size[0] * size[0] * Eigen::Matrix3d::Identity();
      break;
    case Shape::box:
      body.inertia_at_com = box_inertia(mass_kg, Vec3(size[0], size[1], size[2]));
      break;
    case Shape::cylinder: {
      const double r2 = size[0] * size[0];
      body.inertia_at_com = mass_kg * axisymmetric_inertia(size[1] * size[1] / 12 + r2 / 4, r2 / 2);
      break;
    }
    case Shape::capsule: {
      const Inertia unit = unit_capsule(size[0], size[1]);
      body.inertia_at_com = mass_kg / unit.mass * unit.inertia_at_com;
      break;
    }
    case Shape::mesh: {
      Eigen::AlignedBox3d box;
      for (const Vec3& vertex : object.vertices) box.extend(vertex);
      body.centre_of_mass = box.center();
      body.inertia_at_com = box_inertia(mass_kg, box.sizes());
      break;
    }
  }
  return body;
}

double lowest_height(const SceneObject& object, const Pose& pose, const Vec3& up) {
  const Vec3 d = pose.linear().transpose() * up;  // in the object's frame
  const std::vector<double>& size = object.size;
  double extent = 0;  // extent below the centre
  switch (object.shape) {
    case Shape::sphere:
      extent = size[0];
      break;
    case Shape::box:
      extent = 0.5 * d.cwiseAbs().dot(Vec3(size[0], size[1], size[2]));
      break;
    case Shape::cylinder:
      extent = size[0] * d.head<2>().norm() + 0.5 * size[1] * std::abs(d.z());
      break;
    case Shape::capsule:
      extent = size[0] + 0.5 * size[1] * std::abs(d.z());
      break;
    case Shape::mesh:
      extent = -kInfinity;
      for (const Vec3& vertex : object.vertices) extent = std::max(extent, -d.dot(vertex));
      break;
  }
  return up.dot(pose.translation()) - extent;
}

}  // namespace morphe::simulate
