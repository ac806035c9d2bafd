#include "pipeline/setup/setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/robot/files/description.hpp"
#include "pipeline/setup/description_sections.hpp"
#include "pipeline/setup/items_to_check.hpp"
#include "pipeline/setup/limits.hpp"
#include "pipeline/setup/merge_sections.hpp"
#include "pipeline/setup/urdf_analysis.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {

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
  result.to_check = items_to_check(found, limits);
  (void)robot::parse_robot(result.text, request.out);  // are kept sections still consistent?
  return result;
}

}  // namespace morphe::setup
