#include "pipeline/setup/setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/input_error.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/tree.hpp"
#include "pipeline/setup/find_allowed_links.hpp"
#include "pipeline/setup/flange.hpp"
#include "pipeline/setup/joint_centres.hpp"
#include "pipeline/setup/limits.hpp"
#include "pipeline/setup/merge_sections.hpp"
#include "pipeline/setup/natural_posture.hpp"
#include "pipeline/setup/placeholder_shapes.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {
namespace {

namespace fs = std::filesystem;

struct UrdfAnalysis {
  const Kinematics& robot;
  std::vector<int> arm;  ///< moving frames from the base to the hand's root or the last one
  std::optional<Hand> hand;
  std::vector<Pad> pads;
  std::optional<Palm> palm;
  std::optional<Flange> flange;
  std::optional<ArmCentres> centres;
  std::vector<LinkCapsules> capsules;
  std::vector<std::string> placeholder_shape_links;  ///< links that lost placeholder shapes

  /// Returns a name for a generated frame that no frame, joint or link of the file has.
  std::string unique_frame_name(std::string name) const {
    while (robot.model->links.contains(name) || robot.model->joint(name)) name += "_of_setup";
    return name;
  }
  std::string link(int frame) const { return robot.link[frame]; }
  std::string joint(int frame) const { return robot.frame(frame).name; }
  /// Returns false for one or two joints, which are the wrist of a hand.
  bool has_arm() const { return arm.size() > 2; }
  std::string finger_name(const Finger& finger) const { return kFingerNames[finger.finger]; }
};

UrdfAnalysis analyse_urdf(const Kinematics& robot, const SetupRequest& request, LinkShapes shapes) {
  UrdfAnalysis found{robot, {}, find_hand(robot, request.hand), {}, {}, {}, {}, {}, {}};
  if (found.hand) {
    found.arm = joint_frames_between(robot, -1, found.hand->root);
    found.pads = find_pads(robot, *found.hand, shapes.points);
    found.palm = find_palm(robot, *found.hand, found.pads);
    found.hand->side = found.palm->side;
    if (found.hand->gripper) {
      found.placeholder_shape_links =
          remove_finger_placeholder_shapes(robot, *found.hand, found.pads, shapes);
    }
  } else {
    int last = -1;
    for (int f = 0; f < std::ssize(robot.table().frames); ++f)
      if (robot.moves(f)) last = f;
    found.arm = joint_frames_between(robot, -1, last);
    if (!found.has_arm())
      throw InputError(
          fmt::format("{}: contains neither a hand (fingers that branch from one link) nor an arm "
                      "(three consecutive joints)",
                      request.urdf.string()));
    found.flange = find_flange(robot, found.arm);
  }
  if (found.has_arm()) found.centres = arm_centres(robot, found.arm);
  found.capsules = cover_links(robot, found.arm, found.hand ? &*found.hand : nullptr, found.pads,
                               shapes, request.budget);
  return found;
}

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
                        own.lower || own.velocity ? "; what the URDF lacks assumed" : "");
  }
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
    text += fmt::format("  - {{name: {}, first: {}, last: {}}}  # {}\n", found.finger_name(finger),
                        yaml_name(found.joint(finger.frames.front())),
                        yaml_name(found.joint(finger.frames.back())),
                        name_of(finger.finger_provenance));
  }
  return text;
}

std::string frame_line(const std::string& name, const std::string& parent, const Pose& mount,
                       const std::string& remark) {
  return fmt::format("  - {{name: {}, parent: {}, mount: {}}}  # {}\n", name, yaml_name(parent),
                     yaml_mount(mount), remark);
}

std::string frames_section(const UrdfAnalysis& found) {
  std::string text;
  const auto centre = [&](const char* name, const JointCentre& c) {
    const Pose mount(Eigen::Translation3d(c.position));
    text += frame_line(
        found.unique_frame_name(name), found.link(c.frame), mount,
        fmt::format("{}, axes pass it by {:.1f} mm", name_of(c.sure), 1e3 * c.axis_distance_m));
  };
  if (found.centres) {
    centre("shoulder_centre", found.centres->shoulder);
    centre("elbow_centre", found.centres->elbow);
    centre("wrist_centre", found.centres->wrist);
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
  if (found.centres)
    keys += fmt::format("shoulder: {}\n", found.unique_frame_name("shoulder_centre"));
  keys += fmt::format("palm: {}\n", found.unique_frame_name(found.palm ? "palm_frame" : "flange"));
  return (text.empty() ? "" : "frames:\n" + text) + keys;
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

/// Returns the key `allowed_links`, with the names of links, which differ from those of frames.
std::string pairs_text(const robot::RobotDescription& description) {
  std::map<int, std::string> names{{-1, "base"}};
  for (int f = 0; f < std::ssize(description.table.frames); ++f)
    names[f] = description.table.frames[f].name;
  for (const auto& [link, frame] : description.links) names[frame] = link;
  return allowed_links_yaml(find_allowed_links(description.table),
                            [&](int frame) { return names[frame]; });
}

void add_items_to_check(const UrdfAnalysis& found, const std::vector<JointLimits>& limits,
                        SetupResult& result) {
  auto& check = result.to_check;
  if (found.hand) {
    std::vector<std::string> fingers;
    for (const Finger& f : found.hand->fingers) {
      fingers.push_back(fmt::format("{} = {} ({})", found.finger_name(f),
                                    found.joint(f.frames.back()), name_of(f.finger_provenance)));
    }
    check.push_back(
        fmt::format("fingers: {}; a {} hand", fmt::join(fingers, ", "), name_of(found.hand->side)));
    for (int i = 0; i < std::ssize(found.pads); ++i)
      if (found.pads[i].sure == Provenance::assumed)
        check.push_back(fmt::format("tip of {}: the end of the finger is unknown",
                                    found.finger_name(found.hand->fingers[i])));
  }
  if (found.centres && found.centres->shoulder.sure == Provenance::assumed)
    check.push_back("shoulder: the first joint axes do not intersect");
  if (found.centres && found.centres->wrist.sure == Provenance::assumed)
    check.push_back("wrist: the last joint axes do not intersect");
  const auto assumed = std::ranges::count(limits, Provenance::assumed, &JointLimits::sure);
  if (assumed > 0)
    check.push_back(fmt::format("acceleration and jerk of {} assumed",
                                count_with_noun(assumed, "joint is", "joints are")));
  std::vector<std::string> beyond;
  for (const Pad& pad : found.pads)
    if (pad.tip_beyond_shapes) beyond.push_back(found.link(pad.frame));
  if (!beyond.empty())
    check.push_back(fmt::format(
        "shapes of {} end before the fingertips of the URDF: the rest of these fingers is assumed",
        fmt::join(beyond, ", ")));
  if (!found.placeholder_shape_links.empty())
    check.push_back(fmt::format(
        "shapes of {} that contain the finger pads are skipped: the fingers have their own shapes",
        fmt::join(found.placeholder_shape_links, ", ")));
  std::vector<std::string> bones;
  for (const LinkCapsules& link : found.capsules)
    if (link.sure == Provenance::assumed) bones.push_back(found.link(link.frame));
  if (!bones.empty())
    check.push_back(
        fmt::format("shapes of {} are assumed: capsules with the thickness of the link's inertia",
                    fmt::join(bones, ", ")));
}

}  // namespace

SetupResult make_description(const SetupRequest& request,
                             const std::optional<std::string>& before) {
  const robot::UrdfModel model = robot::load_urdf_model(request.urdf);
  const Kinematics robot = kinematics_of(model);
  const LinkShapes shapes = read_shapes(robot, request.package_paths);
  const UrdfAnalysis found = analyse_urdf(robot, request, shapes);
  const std::vector<JointLimits> limits = joint_limits(robot);
  SetupResult result;
  result.notes = model.notes;
  result.notes.insert(result.notes.end(), shapes.notes.begin(), shapes.notes.end());
  const std::string name = request.name.empty() ? model.name : request.name;
  std::vector<Section> sections = {
      {"name", fmt::format("name: {}\n", yaml_name(name))},
      {"urdf", urdf_section(request, limits)},
      {"chains", chains_section(found)},
      {"frames", frames_section(found)},
      {"tips", tips_section(found)},
      {"joint_centres", centres_section(found)},
      {"natural_posture", natural_section(found)},
  };
  if (found.hand && found.hand->side == Side::left) sections.push_back({"side", "side: left\n"});
  std::erase_if(sections, [](const Section& section) { return section.text.empty(); });
  std::string without_pairs;
  for (const Section& section : sections) without_pairs += section.text;
  without_pairs += capsules_section(found, "");
  const robot::RobotDescription bare = robot::parse_robot(without_pairs, request.out);
  sections.push_back({"collision", capsules_section(found, pairs_text(bare))});
  std::vector<std::string> kept;
  result.text = fmt::format(
      "# Made by `morphe robot setup` from {}. What stands below a line that begins with `#:` is\n"
      "# made anew each time, unless somebody changed it: then it stays as it is.\n{}",
      request.urdf.filename().string(),
      before ? merge_sections(sections, *before, kept) : join_sections(sections));
  if (!kept.empty())
    result.notes.push_back(fmt::format("kept because edited: {}", fmt::join(kept, ", ")));
  result.points = shapes.points;  // the frames of the URDF come first in the description
  add_items_to_check(found, limits, result);
  (void)robot::parse_robot(result.text, request.out);  // are kept sections still consistent?
  return result;
}

}  // namespace morphe::setup
