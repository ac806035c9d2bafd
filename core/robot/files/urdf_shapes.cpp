#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/robot/files/read_urdf.hpp"
#include "core/robot/files/robot_file.hpp"

namespace morphe::robot {
namespace {

constexpr double kMatchTolerance_m = 1e-9;
constexpr int kMaxCapsulesPerBox = 8;

using Capsule = RobotModel::Capsule;

struct Shapes {
  const urdf::Link& link;
  std::vector<Capsule> capsules;  ///< in the link's frame

  void add(const Vec3& from, const Vec3& to, double radius) {
    capsules.push_back({"", -1, from, to, radius});
  }

  /// Returns true if the link has a sphere of this radius at that point.
  bool has_sphere(const Vec3& centre, double radius) const {
    return std::ranges::any_of(link.collision_array, [&](const urdf::CollisionSharedPtr& c) {
      const auto* sphere = dynamic_cast<const urdf::Sphere*>(c->geometry.get());
      return sphere && std::abs(sphere->radius - radius) < kMatchTolerance_m &&
             (pose_of(c->origin).translation() - centre).norm() < kMatchTolerance_m;
    });
  }

  void add_cylinder(const Pose& pose, double radius, double length) {
    const Vec3 from = pose * Vec3(0, 0, -length / 2), to = pose * Vec3(0, 0, length / 2);
    const bool has_caps = has_sphere(from, radius) && has_sphere(to, radius);
    const double sphere_radius = std::hypot(radius, length / 2);
    const double capsule_volume = radius * radius * (4.0 / 3 * radius + length);  // divided by pi
    if (!has_caps && 4.0 / 3 * sphere_radius * sphere_radius * sphere_radius < capsule_volume)
      return add(pose.translation(), pose.translation(), sphere_radius);
    add(from, to, radius);
  }

  /// Adds capsules along the longest side, side by side along the second longest, as many as make
  /// the parts of the cross section about square.
  void add_box(const Pose& pose, const Vec3& size) {
    std::array<int, 3> axis = {0, 1, 2};
    std::ranges::sort(axis, [&](int a, int b) { return size[a] > size[b]; });
    const auto [first, second, third] = axis;
    const double ratio = size[third] > 0 ? size[second] / size[third] : kMaxCapsulesPerBox;
    const int count = std::clamp(static_cast<int>(std::lround(ratio)), 1, kMaxCapsulesPerBox);
    const double breadth = size[second] / count;
    const Vec3 along = 0.5 * size[first] * Vec3::Unit(first);
    for (int k = 0; k < count; ++k) {
      const Vec3 middle = (breadth * (k + 0.5) - size[second] / 2) * Vec3::Unit(second);
      add(pose * Vec3(middle - along), pose * Vec3(middle + along),
          0.5 * std::hypot(breadth, size[third]));
    }
  }

  /// Removes spheres inside another capsule of the link.
  void drop_hidden_spheres() {
    const auto hidden = [&](const Capsule& sphere) {
      if (sphere.from != sphere.to) return false;
      return std::ranges::any_of(capsules, [&](const Capsule& other) {
        if (other.from == other.to) return false;
        const Vec3 axis = other.to - other.from;
        const double t =
            std::clamp((sphere.from - other.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
        const double depth = (sphere.from - (other.from + t * axis)).norm() + sphere.radius;
        return depth <= other.radius + kMatchTolerance_m;
      });
    };
    std::vector<Capsule> visible;
    std::ranges::copy_if(capsules, std::back_inserter(visible), std::not_fn(hidden));
    capsules = std::move(visible);
  }
};

const files::XmlElement& link_element(const files::XmlText& text, const std::string& name) {
  for (const files::XmlElement* link : files::children(text.root(), "link")) {
    if (name == link->Attribute("name")) return *link;
  }
  return text.root();
}

std::string free_name(const RobotModel& table, const std::string& name) {
  const auto taken = [&](const std::string& candidate) {
    return std::ranges::count(table.capsules, candidate, &Capsule::name) > 0;
  };
  std::string free = name;
  for (int k = 2; taken(free); ++k) free = fmt::format("{}_{}", name, k);
  return free;
}

}  // namespace

void add_link_shapes(Assembly& assembly, const files::XmlText& text, const urdf::Link& link,
                     int frame, bool use_shapes, const std::string& prefix) {
  const files::XmlElement& element = link_element(text, link.name);
  const std::vector<const files::XmlElement*> elements = files::children(element, "collision");
  Shapes shapes{link, {}};
  if (element.FirstChildElement("visual") || !link.collision_array.empty())
    assembly.frames_with_geometry.push_back(frame);
  if (!use_shapes) return;
  for (int k = 0; k < std::ssize(link.collision_array); ++k) {
    const urdf::Collision& collision = *link.collision_array[k];
    const files::XmlElement& source = k < std::ssize(elements) ? *elements[k] : element;
    const Pose pose = pose_of(collision.origin);
    const std::ptrdiff_t before = std::ssize(shapes.capsules);
    if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(collision.geometry.get())) {
      shapes.add(pose.translation(), pose.translation(), sphere->radius);
    } else if (const auto* rod = dynamic_cast<const urdf::Cylinder*>(collision.geometry.get())) {
      shapes.add_cylinder(pose, rod->radius, rod->length);
    } else if (const auto* box = dynamic_cast<const urdf::Box*>(collision.geometry.get())) {
      shapes.add_box(pose, {box->dim.x, box->dim.y, box->dim.z});
    } else {
      assembly.meshes[text.file.string()].push_back(link.name);
    }
    for (std::ptrdiff_t i = before; i < std::ssize(shapes.capsules); ++i) {
      shapes.capsules[i].name = prefix + (collision.name.empty() ? link.name : collision.name);
      if (!(shapes.capsules[i].radius > 0))
        text.fail(source, fmt::format("link {}.collision", link.name),
                  "has no size: must be above 0");
    }
  }
  shapes.drop_hidden_spheres();
  for (Capsule& capsule : shapes.capsules) {
    capsule.name = free_name(assembly.table, capsule.name);
    capsule.frame = frame;
    assembly.table.capsules.push_back(std::move(capsule));
  }
}

void read_srdf(Assembly& assembly, const FileScope& scope, const std::filesystem::path& file,
               const files::GivenFiles* given) {
  const files::XmlText text = read_urdf_text(file, given);
  assembly.files.push_back(text.file);
  for (const files::XmlElement* pair : files::children(text.root(), "disable_collisions")) {
    std::array<int, 2> frames{};
    bool known = true;
    for (const auto& [k, attribute] : {std::pair{0, "link1"}, std::pair{1, "link2"}}) {
      const std::string link = text.attribute(*pair, attribute);
      const auto found = scope.links.find(scope.prefix + link);
      if (found == scope.links.end()) {
        known = false;
        assembly.notes.push_back(fmt::format("{}:{}: there is no link '{}'; pair ignored",
                                             file.string(), pair->GetLineNum(), link));
      } else {
        frames[k] = found->second;
      }
    }
    if (known) assembly.allowed_frames.push_back(frames);
  }
}

}  // namespace morphe::robot
