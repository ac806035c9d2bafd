#include "pipeline/setup/items_to_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/motion/count_with_noun.hpp"

namespace morphe::setup {

std::vector<std::string> items_to_check(const UrdfAnalysis& found,
                                        const std::vector<JointLimits>& limits) {
  std::vector<std::string> check;
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
  return check;
}

}  // namespace morphe::setup
