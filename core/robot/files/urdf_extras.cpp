#include "core/robot/files/urdf_extras.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>

#include "core/files/xml_text.hpp"
#include "core/robot/files/robot_file.hpp"
#include "core/robot/files/urdf_joints.hpp"

namespace morphe::robot {
namespace {

namespace fs = std::filesystem;

struct Source {
  const files::XmlText& text;
  const UrdfSource& urdf;
  const fs::path& folder;  ///< that will contain the new file

  fs::path relative_to_folder(const std::string& file) const {
    std::error_code ignored;
    const fs::path base = fs::weakly_canonical(fs::absolute(folder), ignored);
    return fs::weakly_canonical(fs::absolute(urdf.file).parent_path() / file, ignored)
        .lexically_proximate(base);
  }

  void rename_files(tinyxml2::XMLElement& element) const {
    const char* name = element.Attribute("filename");
    if (name && *name && !std::strstr(name, "://") && !fs::path(name).is_absolute()) {
      element.SetAttribute("filename", relative_to_folder(name).generic_string().c_str());
    }
    for (auto* child = element.FirstChildElement(); child; child = child->NextSiblingElement())
      rename_files(*child);
  }

  /// Copies the definition of a material, which may be elsewhere in the file, to where it is used.
  void complete_material(tinyxml2::XMLElement& visual) const {
    tinyxml2::XMLElement* material = visual.FirstChildElement("material");
    const char* name = material ? material->Attribute("name") : nullptr;
    if (!name) return;
    if (material->NoChildren()) {
      for (const files::XmlElement* definition : files::children(text.root(), "material")) {
        if (!definition->Attribute("name", name)) continue;
        for (const auto* part = definition->FirstChild(); part; part = part->NextSibling())
          material->InsertEndChild(part->DeepClone(visual.GetDocument()));
        break;
      }
    }
    material->SetAttribute("name", (urdf.prefix + name).c_str());
  }

  std::string copied(const files::XmlElement& element) const {
    tinyxml2::XMLDocument copy;
    auto* const top = element.DeepClone(&copy)->ToElement();
    copy.InsertEndChild(top);
    complete_material(*top);
    rename_files(*top);
    tinyxml2::XMLPrinter printer(nullptr, true);
    copy.Print(&printer);
    return printer.CStr();
  }

  void read_link(const files::XmlElement& link, UrdfExtra& extra) const {
    extra.link = urdf.prefix + link.Attribute("name");
    for (const char* tag : {"inertial", "visual", "collision"}) {
      for (const files::XmlElement* element : files::children(link, tag)) {
        extra.link_elements += "    " + copied(*element) + "\n";
        (*tag == 'i'   ? extra.has_inertial
         : *tag == 'v' ? extra.has_visual
                       : extra.has_collision) = true;
      }
    }
  }

  void read_joint(const files::XmlElement& joint, UrdfExtra& extra) const {
    extra.joint = urdf.prefix + joint.Attribute("name");
    extra.continuous = joint.Attribute("type", "continuous") != nullptr;
    const files::XmlElement* limit = joint.FirstChildElement("limit");
    const char* effort = limit ? limit->Attribute("effort") : nullptr;
    const std::vector<double> number = effort ? numbers_of(effort) : std::vector<double>{};
    if (number.size() == 1 && number.front() > 0) extra.effort = number.front();
    const files::XmlElement* dynamics = joint.FirstChildElement("dynamics");
    if (dynamics) extra.dynamics = "    " + copied(*dynamics) + "\n";
  }

  UrdfExtra& of_link(const std::string& link, std::vector<UrdfExtra>& extras) const {
    return extras[urdf.links.at(link)];
  }
};

/// Returns the sentence that lists the parts for which data are missing, "" if there are none.
std::string missing_sentence(const char* kind, const std::vector<std::string>& parts, int count,
                             const char* ending) {
  if (parts.empty()) return "";
  if (std::ssize(parts) == count) return fmt::format("{}: not given for any part{}", kind, ending);
  return fmt::format("{}: not given for {}{}", kind, fmt::join(parts, ", "), ending);
}

}  // namespace

std::vector<UrdfExtra> urdf_extras(const RobotDescription& robot, const fs::path& folder) {
  std::vector<UrdfExtra> extras(robot.table.frames.size());
  for (const UrdfSource& urdf : robot.urdfs) {
    const files::XmlText text = read_urdf_text(urdf.file);
    const Source source{text, urdf, folder};
    for (const files::XmlElement* link : files::children(text.root(), "link"))
      source.read_link(*link, source.of_link(text.attribute(*link, "name"), extras));
    for (const files::XmlElement* joint : files::children(text.root(), "joint")) {
      const files::XmlElement* child = joint->FirstChildElement("child");
      if (!child) continue;
      source.read_joint(*joint, source.of_link(text.attribute(*child, "link"), extras));
    }
  }
  return extras;
}

std::vector<std::string> missing_details(const RobotModel& robot,
                                         const std::vector<UrdfExtra>& extras) {
  std::vector<std::string> no_effort, no_mass, no_looks;
  int joints = 0, links = 0;
  for (int f = 0; f < std::ssize(extras); ++f) {
    const UrdfExtra& extra = extras[f];
    const RobotModel::Frame& frame = robot.frames[f];
    if (frame.joint >= 0) {
      ++joints;
      if (!extra.effort) no_effort.push_back(frame.name);
    }
    if (extra.link.empty() && frame.joint < 0) continue;  // a marker frame without a body
    ++links;
    const std::string& name = extra.link.empty() ? frame.name : extra.link;
    if (!extra.has_inertial) no_mass.push_back(name);
    if (!extra.has_visual) no_looks.push_back(name);
  }
  std::vector<std::string> sentences = {
      missing_sentence("efforts", no_effort, joints, "; written as 0"),
      missing_sentence("inertias", no_mass, links, ""),
      missing_sentence("visuals", no_looks, links, "")};
  std::erase(sentences, "");
  return sentences;
}

}  // namespace morphe::robot
