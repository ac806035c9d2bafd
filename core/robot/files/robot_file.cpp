#include "core/robot/files/robot_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "core/files/file_kind.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::robot {
namespace {

std::string advice_for(const files::FileKind& kind, std::string_view root) {
  if (kind.unwrapped) return kind.advice;
  if (root == "sdf") return "give the URDF or MJCF of the robot; SDF is not supported";
  if (kind.name.starts_with("a USD"))
    return "export the robot as URDF or MJCF, for example with the URDF exporter of Isaac Sim";
  return "a robot description (YAML), a URDF or an MJCF was expected";
}

/// Returns true for text that may be YAML: lists and maps in braces are YAML and JSON.
bool may_be_yaml(std::string_view head) {
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  return first != head.npos && (head[first] == '{' || head[first] == '[');
}

}  // namespace

RobotFile robot_file_kind(const std::filesystem::path& file, const files::GivenFiles* given) {
  const std::string head = files::read_file_head(file, given);
  const std::string root = files::xml_root_name(head);
  if (root == "robot") return RobotFile::urdf;
  if (root == "mujoco") return RobotFile::mjcf;
  const std::optional<files::FileKind> kind = files::file_kind(head);
  if (!kind || may_be_yaml(head)) return RobotFile::description;
  throw InputError(
      fmt::format("{}: is {}; {}", file.string(), kind->name, advice_for(*kind, root)));
}

files::XmlText read_urdf_text(const std::filesystem::path& file, const files::GivenFiles* given) {
  if (robot_file_kind(file, given) == RobotFile::mjcf) {
    throw InputError(
        fmt::format("{0}: is a model of MuJoCo (MJCF), not a URDF; convert it first: morphe robot "
                    "setup {0} --out OUT.yaml writes OUT.urdf",
                    file.string()));
  }
  return files::XmlText(file, "robot", given);
}

}  // namespace morphe::robot
