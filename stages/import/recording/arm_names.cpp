#include "stages/import/recording/arm_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/motion/human_motion.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {
namespace {

constexpr std::pair<const char*, const char*> kClusters[] = {
    {"SHO", "shoulder girdle"}, {"UAR", "upper arm"}, {"LAR", "forearm"}, {"HAN", "hand"}};
constexpr std::pair<const char*, const char*> kLandmarks[] = {
    {"GTH", "shoulder"},     {"LEP", "elbow, outer"},  {"MEP", "elbow, inner"},
    {"SPR", "wrist, thumb"}, {"SPU", "wrist, little"}, {"FB", "index mcp"},
    {"FTP", "index tip"},    {"THUM", "thumb tip"}};
constexpr const char* kJoints[] = {"shoulder", "elbow", "wrist", "hip"};

/// Returns the part of a joint's name after its side, such as "index_tip"; "" for any other name.
std::string joint_part(const std::string& name) {
  const std::size_t underscore = name.find('_');
  if (underscore == std::string::npos) return "";
  const std::string side = name.substr(0, underscore), part = name.substr(underscore + 1);
  if (!enum_from_name<Side>(side)) return "";
  if (std::ranges::find(kJoints, part) != std::end(kJoints)) return part;
  for (int finger = 0; finger < std::ssize(kFingerNames); ++finger) {
    const std::vector<std::string> joints = finger_joint_names(finger);
    if (std::ranges::find(joints, part) != joints.end()) return part;
  }
  return "";
}

}  // namespace

std::vector<std::string> finger_joint_names(std::size_t finger) {
  static constexpr const char* kThumbJoints[] = {"cmc", "mcp", "ip", "tip"};
  static constexpr const char* kFingerJointNames[] = {"mcp", "pip", "dip", "tip"};
  std::vector<std::string> names;
  for (const char* joint : finger == kThumb ? kThumbJoints : kFingerJointNames)
    names.push_back(fmt::format("{}_{}", kFingerNames[finger], joint));
  return names;
}

bool is_joint_name(const std::string& name) { return !joint_part(name).empty(); }

std::string body_part(const std::string& name) {
  if (std::string part = joint_part(name); !part.empty()) {
    std::ranges::replace(part, '_', ' ');
    return fmt::format("{} {}", name.substr(0, name.find('_')), part);
  }
  if (name.size() < 2 || (name[0] != 'R' && name[0] != 'L')) return "";
  const char* side = name[0] == 'R' ? "right" : "left";
  const std::string rest = name.substr(1);
  for (const auto& [short_name, part] : kLandmarks) {
    if (rest == short_name) return fmt::format("{} {}", side, part);
  }
  for (const auto& [short_name, part] : kClusters) {
    const std::size_t length = std::string(short_name).size();
    const bool numbered = rest.starts_with(short_name) && rest.size() > length &&
                          rest.find_first_not_of("0123456789", length) == std::string::npos;
    if (numbered) return fmt::format("{} {}", side, part);
  }
  return "";
}

}  // namespace morphe::imports
