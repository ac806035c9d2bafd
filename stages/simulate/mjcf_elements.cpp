#include "stages/simulate/mjcf_elements.hpp"

#include <fmt/format.h>

namespace morphe::simulate {

std::string numbers(const Vec3& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

std::string pose_attributes(const Pose& pose) {
  const Quat q(pose.linear());
  return fmt::format("pos=\"{}\" quat=\"{:.17g} {:.17g} {:.17g} {:.17g}\"",
                     numbers(pose.translation()), q.w(), q.x(), q.y(), q.z());
}

std::string inertial(const Inertia& body) {
  const Eigen::Matrix3d& i = body.inertia_at_com;
  return fmt::format(
      "<inertial pos=\"{}\" mass=\"{:.17g}\" fullinertia=\"{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} "
      "{:.17g}\"/>\n",
      numbers(body.centre_of_mass), body.mass, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2),
      i(1, 2));
}

std::string capsule_geom(const RobotModel::Capsule& capsule, int k) {
  if ((capsule.to - capsule.from).norm() < 1e-9)
    return fmt::format("<geom name=\"c{}\" type=\"sphere\" size=\"{:.17g}\" pos=\"{}\" {}/>\n", k,
                       capsule.radius, numbers(capsule.from), kGeomAttributes);
  return fmt::format("<geom name=\"c{}\" type=\"capsule\" size=\"{:.17g}\" fromto=\"{} {}\" {}/>\n",
                     k, capsule.radius, numbers(capsule.from), numbers(capsule.to),
                     kGeomAttributes);
}

std::string object_geom(const SceneObject& object, const std::string& name, const Pose& pose) {
  const std::vector<double>& s = object.size;
  std::string shape;
  switch (object.shape) {
    case Shape::sphere:
      shape = fmt::format("type=\"sphere\" size=\"{:.17g}\"", s[0]);
      break;
    case Shape::box:
      shape = fmt::format("type=\"box\" size=\"{}\"", numbers(0.5 * Vec3(s[0], s[1], s[2])));
      break;
    case Shape::cylinder:
      shape = fmt::format("type=\"cylinder\" size=\"{:.17g} {:.17g}\"", s[0], 0.5 * s[1]);
      break;
    case Shape::capsule:
      shape = fmt::format("type=\"capsule\" size=\"{:.17g} {:.17g}\"", s[0], 0.5 * s[1]);
      break;
    case Shape::mesh:
      shape = fmt::format("type=\"mesh\" mesh=\"{}\"", name);
      break;
  }
  return fmt::format("<geom name=\"{}\" {} {} {}/>\n", name, shape, pose_attributes(pose),
                     kGeomAttributes);
}

}  // namespace morphe::simulate
