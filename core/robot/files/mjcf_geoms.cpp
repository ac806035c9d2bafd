#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/motion/enum_names.hpp"
#include "core/robot/files/mjcf_parts.hpp"

namespace morphe::robot {
namespace {

/// The shapes of MuJoCo.
enum class MjcfShape { plane, hfield, sphere, capsule, ellipsoid, cylinder, box, mesh, sdf };
constexpr std::array<std::string_view, 9> names_of(MjcfShape) {
  return {"plane", "hfield", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "sdf"};
}

constexpr int kLastShownGroup = 2;  ///< MuJoCo's viewer shows the groups 0 to 2

/// Places a shape along a line, as `fromto` says: z from the first to the second end, and sizes
/// that are half the shape's, with half the length of the line as the last.
void place_between(const MjcfElement& element, const std::vector<double>& ends, UrdfShape& shape,
                   Vec3& half_sizes) {
  const Vec3 from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
  const Vec3 along = from - to;  // MuJoCo's direction, which matters for boxes
  if (!(along.norm() > 0)) element.fail("fromto", "must not have equal ends");
  shape.link_from_shape = make_pose(0.5 * (from + to), rotation_from_z_to(along.normalized()));
  half_sizes = {half_sizes.x(), half_sizes.x(), 0.5 * along.norm()};
}

/// Makes the shape the capsule around an ellipsoid with these half axes: of the second longest one
/// as radius, touching both ends of the longest.
void enclose_ellipsoid(const Vec3& half_axes, UrdfShape& shape) {
  std::array<int, 3> order = {0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return half_axes[a] > half_axes[b]; });
  const double radius = half_axes[order[1]], half_length = half_axes[order[0]] - radius;
  shape.kind = half_length > 0 ? Shape::capsule : Shape::sphere;
  shape.size = {radius, 2 * half_length, 0};
  const Quat along = rotation_from_z_to(Vec3::Unit(order[0]));
  shape.link_from_shape.linear() = shape.link_from_shape.linear() * along.toRotationMatrix();
}

/// Returns how many of the three half sizes a shape has.
std::size_t size_count(MjcfShape kind) {
  if (kind == MjcfShape::sphere) return 1;
  return kind == MjcfShape::capsule || kind == MjcfShape::cylinder ? 2 : 3;
}

void read_primitive(const MjcfElement& element, MjcfShape kind, UrdfShape& shape) {
  const std::vector<double> ends = element.numbers("fromto", 6, 6);
  const std::size_t needed = ends.empty() ? size_count(kind) : 1;
  const std::vector<double> written = element.numbers("size", needed, 3);
  if (written.empty()) element.fail("size", "is missing");
  Vec3 half = Vec3::Zero();
  std::ranges::copy(written, half.data());
  shape.link_from_shape = element.pose();
  if (!ends.empty() && kind != MjcfShape::sphere) place_between(element, ends, shape, half);
  const bool capsule_like = kind == MjcfShape::capsule || kind == MjcfShape::cylinder;
  if (capsule_like && !ends.empty()) half = {half.x(), half.z(), 0};
  for (std::size_t k = 0; k < size_count(kind); ++k)
    if (!(half[static_cast<Eigen::Index>(k)] > 0)) element.fail("size", "must be above 0");
  if (kind == MjcfShape::ellipsoid) return enclose_ellipsoid(half, shape);
  shape.kind = enum_from_name<Shape>(name_of(kind)).value();
  shape.size = kind == MjcfShape::box ? Vec3(2 * half) : Vec3(half.x(), 2 * half.y(), 0);
}

/// Reads a shape that is a mesh. Returns false, with a note, if it has no file or is distorted.
bool read_mesh_geom(const MjcfElement& element, const std::map<std::string, MjcfMesh>& meshes,
                    UrdfShape& shape, std::vector<std::string>& notes) {
  const std::string name = element.text_or("mesh", "");
  if (name.empty()) element.fail("mesh", "is missing");
  const auto found = meshes.find(name);
  if (found == meshes.end()) element.fail("mesh", fmt::format("there is no mesh '{}'", name));
  const MjcfMesh& mesh = found->second;
  const bool turned = !mesh.reference.linear().isIdentity(1e-12);
  const bool uniform = mesh.scale.isConstant(mesh.scale.x(), 1e-12);
  if (mesh.file.empty() || (turned && !uniform)) {
    notes.push_back(fmt::format("{}: mesh '{}' {}; the shape is left out",
                                element.source.file.place(element.xml), name,
                                mesh.file.empty() ? "has no file" : "is distorted by its refquat"));
    return false;
  }
  shape.kind = Shape::mesh;
  shape.mesh = mesh.file.string();
  shape.size = mesh.scale;
  const Eigen::Matrix3d back = mesh.reference.linear().transpose();
  Pose mesh_from_file = Pose::Identity();
  mesh_from_file.linear() = back;
  mesh_from_file.translation() =
      -mesh.scale.cwiseProduct(Vec3(back * mesh.reference.translation()));
  shape.link_from_shape = element.pose() * mesh_from_file;
  return true;
}

bool has_bit(const MjcfElement& element, const char* name) { return element.number(name, 1) != 0; }

}  // namespace

std::map<std::string, MjcfMesh> read_mjcf_meshes(const MjcfSource& source) {
  std::map<std::string, MjcfMesh> meshes;
  const std::filesystem::path folder =
      source.file.path().parent_path() / source.settings.mesh_folder;
  for (const files::XmlElement* asset : source.file.sections("asset")) {
    for (const files::XmlElement* xml : source.file.elements(*asset, "mesh")) {
      const MjcfElement element{source, *xml};
      std::filesystem::path file = element.text_or("file", "");
      if (source.settings.strip_path) file = file.filename();
      const std::string name = element.name().empty() ? file.stem().string() : element.name();
      if (name.empty()) element.fail("name", "is missing");
      MjcfMesh mesh;
      if (!file.empty()) mesh.file = (folder / file).lexically_normal();
      mesh.scale = element.vector("scale", Vec3::Ones());
      const std::vector<double> quat = element.numbers("refquat", 4, 4);
      if (!quat.empty()) {
        const Quat turn = Quat(quat[0], quat[1], quat[2], quat[3]).normalized();
        mesh.reference.linear() = turn.toRotationMatrix();
      }
      mesh.reference.translation() = element.vector("refpos", Vec3::Zero());
      if (!meshes.emplace(name, mesh).second)
        element.fail("name", fmt::format("'{}' appears twice", name));
    }
  }
  return meshes;
}

std::optional<MjcfGeom> read_mjcf_geom(const MjcfElement& element,
                                       const std::map<std::string, MjcfMesh>& meshes,
                                       std::vector<std::string>& notes) {
  const std::string word = element.text_or("type", "sphere");
  std::optional<MjcfShape> kind = enum_from_name<MjcfShape>(word);
  if (!kind)
    element.fail("type", fmt::format("must be {}, not '{}'", list_names<MjcfShape>(), word));
  if (element.text("mesh")) kind = MjcfShape::mesh;  // a primitive is then fitted to the mesh
  if (*kind == MjcfShape::plane || *kind == MjcfShape::hfield || *kind == MjcfShape::sdf) {
    notes.push_back(fmt::format("{}: a {} cannot be a link's shape; it is left out",
                                element.source.file.place(element.xml), word));
    return std::nullopt;
  }
  MjcfGeom geom;
  geom.name = element.name();
  geom.collides = has_bit(element, "contype") || has_bit(element, "conaffinity");
  geom.shown = element.number("group", 0) <= kLastShownGroup;
  if (*kind != MjcfShape::mesh)
    read_primitive(element, *kind, geom.shape);
  else if (!read_mesh_geom(element, meshes, geom.shape, notes))
    return std::nullopt;
  if (*kind == MjcfShape::ellipsoid) {
    notes.push_back(fmt::format("{}: the ellipsoid is replaced by the capsule around it",
                                element.source.file.place(element.xml)));
  }
  return geom;
}

}  // namespace morphe::robot
