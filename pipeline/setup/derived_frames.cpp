#include "pipeline/setup/derived_frames.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/robot/forward_kinematics.hpp"

namespace morphe::setup {
namespace {

/// Describes how sure a joint centre is, and which axes pass it.
std::string certainty_of(const UrdfAnalysis& found, const JointCentre& centre) {
  std::string text =
      fmt::format("{}, axes within {:.1f} mm", name_of(centre.sure), 1e3 * centre.axis_distance_m);
  for (const JointCentre::Offset& offset : centre.offset_axes)
    text +=
        fmt::format("; {} passes at {:.0f} mm", found.joint(offset.frame), 1e3 * offset.distance_m);
  return text;
}

}  // namespace

std::vector<DerivedFrame> derived_frames(const UrdfAnalysis& found,
                                         const robot::RobotDescription& description,
                                         const std::vector<std::string>& kept) {
  const RobotModel& table = description.table;
  std::vector<Pose> poses;
  robot::forward_kinematics(table, rest_position(table), poses);
  const bool edited = std::ranges::find(kept, "frames") != kept.end();
  std::vector<DerivedFrame> derived;
  const auto add = [&](const std::string& name, int frame, const std::string& certainty) {
    const auto at = std::ranges::find(table.frames, name, &RobotModel::Frame::name);
    if (at == table.frames.end()) return;
    derived.push_back({name, found.link(frame), poses[at - table.frames.begin()].translation(),
                       edited ? "edited" : certainty});
  };
  if (found.roles) {
    const ArmCentres& centres = found.roles->centres;
    for (const auto& [name, centre] :
         {std::pair{"shoulder_centre", centres.shoulder}, std::pair{"elbow_centre", centres.elbow},
          std::pair{"wrist_centre", centres.wrist}})
      add(found.unique_frame_name(name), centre.frame, certainty_of(found, centre));
  }
  if (found.flange)
    add(found.unique_frame_name("flange"), found.flange->frame,
        std::string(name_of(found.flange->sure)));
  if (found.palm)
    add(found.unique_frame_name("palm_frame"), found.hand->root,
        std::string(name_of(found.palm->sure)));
  return derived;
}

}  // namespace morphe::setup
