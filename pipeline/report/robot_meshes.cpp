#include "pipeline/report/robot_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "core/collision/mesh_file.hpp"
#include "core/files/xml_text.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::report {
namespace {

namespace fs = std::filesystem;

struct Visual {
  fs::path file;
  std::string mesh_name;
  Pose link_from_mesh = Pose::Identity();
  Vec3 scale = Vec3::Ones();
};

Vec3 parse_vector(const char* text, Vec3 vector) {
  if (text != nullptr) std::istringstream(text) >> vector.x() >> vector.y() >> vector.z();
  return vector;
}

/// All files below a folder, in the order of their paths.
struct Folder {
  std::vector<fs::path> files;

  explicit Folder(const fs::path& folder) {
    std::error_code error;
    for (fs::recursive_directory_iterator next(folder, error), end; !error && next != end;
         next.increment(error)) {
      if (next->is_regular_file()) files.push_back(next->path());
    }
    if (error) throw InputError(fmt::format("{}: cannot be read", folder.string()));
    std::ranges::sort(files);
  }
  /// Returns the first file whose path ends in the name, or else in the longest possible end of it.
  fs::path find(std::string name) const {
    if (const auto scheme = name.find("://"); scheme != std::string::npos)
      name.erase(0, scheme + 3);
    for (fs::path tail = fs::path(name).lexically_normal().relative_path(); !tail.empty();
         tail = tail.lexically_relative(*tail.begin())) {
      for (const fs::path& file : files) {
        if (ends_in(file, tail)) return file;
      }
      if (std::next(tail.begin()) == tail.end()) break;
    }
    return {};
  }

 private:
  static bool ends_in(const fs::path& file, const fs::path& tail) {
    return file.string().ends_with("/" + tail.string());
  }
};

Visual visual_of(const files::XmlElement& element, const files::XmlElement& mesh,
                 const Folder& folder) {
  Visual visual;
  const char* name = mesh.Attribute("filename");
  visual.mesh_name = name == nullptr ? "" : name;
  visual.file = folder.find(visual.mesh_name);
  visual.scale = parse_vector(mesh.Attribute("scale"), Vec3::Ones());
  if (const files::XmlElement* origin = element.FirstChildElement("origin")) {
    const Vec3 rpy = parse_vector(origin->Attribute("rpy"), Vec3::Zero());
    visual.link_from_mesh.translation() = parse_vector(origin->Attribute("xyz"), Vec3::Zero());
    visual.link_from_mesh.linear() =
        (Eigen::AngleAxisd(rpy.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Vec3::UnitY()) *
         Eigen::AngleAxisd(rpy.x(), Vec3::UnitX()))
            .toRotationMatrix();
  }
  return visual;
}

/// Returns the visuals of a URDF by the names of their links and of the joints of these.
std::multimap<std::string, Visual> visuals_of(const fs::path& urdf, const Folder& folder) {
  const files::XmlText text(urdf, "robot");
  std::map<std::string, std::string> joint_of_link;
  for (const files::XmlElement* joint : files::children(text.root(), "joint")) {
    const files::XmlElement* child = joint->FirstChildElement("child");
    if (child == nullptr || child->Attribute("link") == nullptr) continue;
    joint_of_link[child->Attribute("link")] = text.attribute(*joint, "name");
  }
  std::multimap<std::string, Visual> visuals;
  for (const files::XmlElement* link : files::children(text.root(), "link")) {
    const std::string name = text.attribute(*link, "name");
    for (const files::XmlElement* element : files::children(*link, "visual")) {
      const files::XmlElement* geometry = element->FirstChildElement("geometry");
      const files::XmlElement* mesh =
          geometry == nullptr ? nullptr : geometry->FirstChildElement("mesh");
      if (mesh == nullptr) continue;
      const Visual visual = visual_of(*element, *mesh, folder);
      visuals.emplace(name, visual);
      if (const auto joint = joint_of_link.find(name); joint != joint_of_link.end())
        visuals.emplace(joint->second, visual);
    }
  }
  return visuals;
}

/// Adds the mesh of a visual to `found`. Returns "" or a description of the error.
std::string load_into(const Visual& visual, int frame, FoundMeshes& found) {
  if (visual.file.empty())
    return fmt::format("{}: not found in the folder of meshes", visual.mesh_name);
  SceneObject surface;
  const std::string error = collision::load_raw_mesh(visual.file, surface);
  if (!error.empty()) return error;
  FrameMesh mesh;
  mesh.frame = frame;
  for (const Vec3& corner : surface.vertices)
    mesh.vertices.push_back(visual.link_from_mesh * corner.cwiseProduct(visual.scale));
  mesh.triangles = std::move(surface.triangles);
  found.meshes.push_back(std::move(mesh));
  return "";
}

}  // namespace

FoundMeshes find_meshes(const RobotModel& robot, const fs::path& path) {
  const Folder folder(path);
  std::multimap<std::string, Visual> visuals;
  for (const fs::path& file : folder.files) {
    if (file.extension() != ".urdf") continue;
    // The first of several URDFs that contain a name is used.
    std::multimap<std::string, Visual> file_visuals = visuals_of(file, folder);
    std::erase_if(file_visuals, [&](const auto& entry) { return visuals.contains(entry.first); });
    visuals.merge(file_visuals);
  }
  FoundMeshes found;
  std::set<std::string> notes;
  for (int i = 0; i < std::ssize(robot.frames); ++i) {
    const std::string& name = robot.frames[i].name;
    const auto [begin, end] = visuals.equal_range(name);
    std::vector<Visual> frame_visuals;
    for (auto entry = begin; entry != end; ++entry) frame_visuals.push_back(entry->second);
    if (frame_visuals.empty()) {
      for (const char* extension : {".stl", ".obj", ".dae", ".glb"}) {
        Visual visual;
        visual.mesh_name = name + extension;
        visual.file = folder.find(visual.mesh_name);
        if (!visual.file.empty()) frame_visuals.push_back(visual);
      }
    }
    for (const Visual& visual : frame_visuals) {
      const std::string error = load_into(visual, i, found);
      if (!error.empty()) notes.insert(error);
    }
  }
  found.notes.assign(notes.begin(), notes.end());
  if (found.meshes.empty()) found.notes.push_back("no mesh for a frame of this robot found");
  return found;
}

}  // namespace morphe::report
