#include "pipeline/setup/description_sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <map>
#include <set>

#include "core/robot/tree.hpp"
#include "pipeline/setup/natural_posture.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;

std::string frame_line(const std::string& name, const std::string& parent, const Pose& mount,
                       const std::string& remark) {
  return fmt::format("  - {{name: {}, parent: {}, mount: {}}}  # {}\n", name, yaml_name(parent),
                     yaml_mount(mount), remark);
}

/// Returns the end of the remark on a joint's limits.
std::string limit_remark(const JointLimits& own) {
  std::string remark;
  if (own.motor_velocity > 0)
    remark += fmt::format("; velocity assumed, the URDF's {:.4g} is a motor's without load",
                          own.motor_velocity);
  if (own.position_given) remark += "; lower and upper as given";
  const bool lacks =
      (own.lower && !own.position_given) || (own.velocity && own.motor_velocity == 0);
  return remark + (lacks ? "; what the URDF lacks assumed" : "");
}

}  // namespace

std::string urdf_section(const SetupRequest& request, const std::vector<JointLimits>& limits) {
  const fs::path folder = fs::absolute(request.out).parent_path();
  const fs::path file = fs::absolute(request.urdf).lexically_proximate(folder);
  std::string text =
      fmt::format("urdf:\n  file: {}\n  shapes: ignore  # those below stand for them\n  limits:\n",
                  yaml_name(file.string()));
  for (const JointLimits& own : limits) {
    text += fmt::format("    - {{joint: {}, ", yaml_name(own.joint));
    if (own.lower)
      text +=
          fmt::format("lower: {}, upper: {}, ", yaml_number(*own.lower), yaml_number(*own.upper));
    if (own.velocity) text += fmt::format("velocity: {}, ", yaml_number(*own.velocity));
    text += fmt::format("acceleration: {}, jerk: {}", yaml_number(own.acceleration),
                        yaml_number(own.jerk));
    if (own.braking)
      text += fmt::format(
          ", braking: {{twice_deceleration: {}, velocity_offset: {}, lower_end: {}, upper_end: "
          "{}}}",
          yaml_number(own.braking->twice_deceleration), yaml_number(own.braking->velocity_offset),
          yaml_number(own.braking->lower_end), yaml_number(own.braking->upper_end));
    text += fmt::format("}}  # {}{}\n", own.source.empty() ? "assumed: 3 v, 50 a" : own.source,
                        limit_remark(own));
  }
  return text;
}

std::string assumed_section(const UrdfAnalysis& found, const std::vector<JointLimits>& limits) {
  std::vector<std::string> joints, links;
  for (const JointLimits& own : limits)
    if (own.source.empty()) joints.push_back(own.joint);
  for (const LinkCapsules& link : found.capsules)
    if (link.sure == Provenance::assumed) links.push_back(found.link(link.frame));
  if (joints.empty() && links.empty()) return "assumed: {}\n";
  std::string text = "assumed:\n";
  if (!joints.empty())
    text +=
        fmt::format("  limits: {}\n",
                    yaml_name(fmt::format("acceleration is three times the velocity per second, "
                                          "jerk fifty times the acceleration per second, of {}",
                                          fmt::join(joints, ", "))));
  if (!links.empty())
    text += fmt::format("  geometry: {}\n",
                        yaml_name(fmt::format("capsules of {}, whose shapes are not known",
                                              fmt::join(links, ", "))));
  return text;
}

std::string chains_section(const UrdfAnalysis& found) {
  std::string text = "chains:\n";
  if (found.has_arm()) {
    text += fmt::format("  - {{name: arm, first: {}, last: {}}}\n",
                        yaml_name(found.joint(found.arm.front())),
                        yaml_name(found.joint(found.arm.back())));
  }
  if (!found.hand) return text;
  for (const Finger& finger : found.hand->fingers) {
    if (finger.frames.empty()) continue;  // a fixed jaw
    text += fmt::format("  - {{name: {}, first: {}, last: {}}}  # {}\n", found.finger_name(finger),
                        yaml_name(found.joint(finger.frames.front())),
                        yaml_name(found.joint(finger.frames.back())),
                        name_of(finger.finger_provenance));
  }
  return text;
}

std::string frames_section(const UrdfAnalysis& found) {
  std::string text;
  const auto centre = [&](const char* name, const JointCentre& c) {
    const Pose mount(Eigen::Translation3d(c.position));
    text += frame_line(
        found.unique_frame_name(name), found.link(c.frame), mount,
        fmt::format("{}, axes pass it by {:.1f} mm", name_of(c.sure), 1e3 * c.axis_distance_m));
  };
  if (found.roles) {
    centre("shoulder_centre", found.roles->centres.shoulder);
    centre("elbow_centre", found.roles->centres.elbow);
    centre("wrist_centre", found.roles->centres.wrist);
  }
  if (found.flange)
    text += frame_line(found.unique_frame_name("flange"), found.link(found.flange->frame),
                       found.flange->frame_from_flange,
                       fmt::format("z outwards; {}", name_of(found.flange->sure)));
  if (found.palm)
    text += frame_line(
        found.unique_frame_name("palm_frame"), found.link(found.hand->root),
        found.palm->root_from_palm,
        fmt::format("z to the fingers, x out of the palm; {}", name_of(found.palm->sure)));
  std::string keys;
  if (found.roles)
    keys += fmt::format("shoulder: {}\n", found.unique_frame_name("shoulder_centre"));
  keys += fmt::format("palm: {}\n", found.unique_frame_name(found.palm ? "palm_frame" : "flange"));
  return (text.empty() ? "" : "frames:\n" + text) + keys;
}

std::string fixed_joints_section(const UrdfAnalysis& found) {
  if (!found.roles) return "";
  std::string text;
  std::set<int> written;
  for (const int frame : found.roles->trunk) {
    const int joint = found.robot.frame(frame).joint;
    if (!written.insert(joint).second) continue;
    text += fmt::format("  - {{joint: {}, position: {}}}\n",
                        yaml_name(found.robot.table().joint_names[joint]),
                        yaml_number(found.robot.rest[joint]));
  }
  return text.empty() ? "" : "fixed_joints:  # before the shoulder: trunk, lift or base\n" + text;
}

std::string tips_section(const UrdfAnalysis& found) {
  std::string text = "tips:  # z along the last bone, x out of the pad, on the pad's surface\n";
  if (!found.hand)
    return text + fmt::format("  - {{name: wrist, frame: {}, finger: wrist}}\n",
                              found.unique_frame_name("flange"));
  for (int i = 0; i < std::ssize(found.pads); ++i) {
    const Pad& pad = found.pads[i];
    const std::string finger = found.finger_name(found.hand->fingers[i]);
    text +=
        fmt::format("  - {{name: {}_tip, frame: {}, finger: {}, pad_depth: {}, mount: {}}}  # {}",
                    finger, yaml_name(found.link(pad.frame)), finger, yaml_number(kPadDepth_m),
                    yaml_mount(pad.frame_from_pad), name_of(pad.sure));
    if (!pad.urdf_tip_link.empty()) {
      const Vec3 off = pad.urdf_tip - pad.frame_from_pad.translation();
      text += fmt::format("; the file's {} lies at {}, {:.1f} mm from it", pad.urdf_tip_link,
                          yaml_vector(pad.urdf_tip), 1e3 * off.norm());
    }
    text += "\n";
  }
  return text;
}

std::string centres_section(const UrdfAnalysis& found) {
  std::string text;
  if (found.has_arm()) {
    text += fmt::format("  - {{chain: arm, frame: {}}}\n", found.unique_frame_name("elbow_centre"));
    if (found.hand)
      text +=
          fmt::format("  - {{chain: arm, frame: {}}}\n", found.unique_frame_name("wrist_centre"));
  }
  if (found.hand) {
    for (const Finger& finger : found.hand->fingers) {
      const int middle = middle_joint(found.robot, finger);
      if (middle < 0) continue;
      text += fmt::format("  - {{chain: {}, frame: {}}}\n", found.finger_name(finger),
                          yaml_name(found.link(middle)));
    }
  }
  return text.empty() ? "" : "joint_centres:\n" + text;
}

std::string natural_section(const UrdfAnalysis& found) {
  if (!found.hand) return "";
  const std::vector<robot::NaturalJoint> natural = natural_posture(found.robot, *found.hand);
  if (natural.empty()) return "";
  std::string text = "natural_posture:  # what fingers do that have no goal\n";
  for (const robot::NaturalJoint& joint : natural) {
    text += fmt::format("  - {{joint: {}", yaml_name(joint.joint));
    if (!joint.follow.empty()) text += fmt::format(", follow: {}", yaml_name(joint.follow));
    if (joint.value != 0) text += fmt::format(", value: {}", yaml_number(joint.value));
    text += "}\n";
  }
  return text;
}

std::string capsules_section(const UrdfAnalysis& found, const std::string& allowed) {
  if (found.capsules.empty()) return "";
  std::string text = "collision:\n  capsules:\n", touch;
  for (const LinkCapsules& link : found.capsules) {
    const cover::FitQuality& f = link.figures;
    text += link.sure == Provenance::assumed
                ? fmt::format("    # {}: no shape in the URDF, assumed\n", found.link(link.frame))
                : fmt::format(
                      "    # {}: {:.1f} % inside, {:.2f} mm outside at most, {:.1f} mm off "
                      "the surface (95 %: {:.1f})\n",
                      found.link(link.frame), 100 * f.coverage, 1e3 * f.largest_gap_m,
                      1e3 * f.standoff_median_m, 1e3 * f.standoff_95_m);
    for (int k = 0; k < std::ssize(link.capsules); ++k) {
      const RobotModel::Capsule& c = link.capsules[k];
      const std::string name = fmt::format("{}_{}", found.link(link.frame), k + 1);
      text += fmt::format("    - {{name: {}, frame: {}, from: {}, to: {}, radius: {}}}\n",
                          yaml_name(name), yaml_name(found.link(link.frame)), yaml_vector(c.from),
                          yaml_vector(c.to), yaml_number(c.radius));
      if (found.hand && robot::is_in_subtree(found.robot.table(), link.frame, found.hand->root))
        touch += fmt::format("{}{}", touch.empty() ? "" : ", ", yaml_name(name));
    }
  }
  text += allowed;
  if (!touch.empty()) text += fmt::format("  may_touch_target: [{}]\n", touch);
  return text;
}

std::function<std::string(int)> link_names(const robot::RobotDescription& description) {
  std::map<int, std::string> names{{-1, "base"}};
  for (int f = 0; f < std::ssize(description.table.frames); ++f)
    names[f] = description.table.frames[f].name;
  for (const auto& [link, frame] : description.links) names[frame] = link;
  return [names = std::move(names)](int frame) { return names.at(frame); };
}

std::string check_section(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += fmt::format("  - {}\n", yaml_text(item));
  return text.empty() ? "" : "check:  # delete a line that is done\n" + text;
}

}  // namespace morphe::setup
