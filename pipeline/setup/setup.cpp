#include "pipeline/setup/setup.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/motion/input_error.hpp"
#include "core/robot/files/description.hpp"
#include "pipeline/setup/clear_covers.hpp"
#include "pipeline/setup/derived_frames.hpp"
#include "pipeline/setup/description_sections.hpp"
#include "pipeline/setup/edited_chains.hpp"
#include "pipeline/setup/items_to_check.hpp"
#include "pipeline/setup/limits.hpp"
#include "pipeline/setup/merge_sections.hpp"
#include "pipeline/setup/urdf_analysis.hpp"
#include "pipeline/setup/yaml_text.hpp"

namespace morphe::setup {

namespace {

/// Reads a description that was made. What cannot be read is a fault of setup, unless a person
/// edited sections, which are then named.
robot::RobotDescription read_back(const std::string& text, const SetupRequest& request,
                                  const std::vector<std::string>& kept) {
  try {
    return robot::parse_robot(text, request.out);
  } catch (const InputError& error) {
    throw InputError(
        kept.empty()
            ? fmt::format("{}: setup made a description that cannot be read, which is a fault of "
                          "Morphe; please report it with the URDF:\n{}",
                          request.urdf.string(), error.what())
            : fmt::format("{}\n{}: does not fit the sections that were edited and kept: {}",
                          error.what(), request.urdf.string(), fmt::join(kept, ", ")));
  }
}

/// Returns all sections but that of the capsules.
std::vector<Section> sections_without_shapes(const SetupRequest& request, const std::string& name,
                                             const UrdfAnalysis& found,
                                             const std::vector<JointLimits>& limits) {
  std::vector<Section> sections = {
      {"name", fmt::format("name: {}\n", yaml_name(name))},
      {"assumed", assumed_section(found, limits)},
      {"urdf", urdf_section(request, limits)},
      {"chains", chains_section(found)},
      {"fixed_joints", fixed_joints_section(found)},
      {"frames", frames_section(found)},
      {"tips", tips_section(found)},
      {"joint_centres", centres_section(found)},
      {"natural_posture", natural_section(found)},
  };
  if (found.hand && found.hand->side == Side::left) sections.push_back({"side", "side: left\n"});
  std::erase_if(sections, [](const Section& section) { return section.text.empty(); });
  return sections;
}

}  // namespace

SetupResult make_description(const SetupRequest& asked, const std::optional<std::string>& before) {
  SetupRequest request = asked;
  if (before) follow_edited_chains(*before, request);
  const robot::UrdfModel model = robot::load_urdf_model(request.urdf, request.limits);
  const Kinematics robot = kinematics_of(model);
  const LinkShapes shapes = read_shapes(robot, request.package_paths);
  UrdfAnalysis found = analyse_urdf(robot, request, shapes);
  const std::vector<JointLimits> limits = joint_limits(robot, request.limits);
  SetupResult result;
  result.notes = model.notes;
  for (const auto& notes : {shapes.notes, found.notes})
    result.notes.insert(result.notes.end(), notes.begin(), notes.end());
  std::vector<std::string> kept;
  const auto joined = [&](const std::vector<Section>& sections) {
    kept.clear();
    return before ? merge_sections(sections, *before, kept) : join_sections(sections);
  };
  std::vector<Section> sections = sections_without_shapes(
      request, request.name.empty() ? model.name : request.name, found, limits);
  const robot::RobotDescription bare =
      robot::parse_robot(joined(sections) + capsules_section(found, ""), request.out);
  if (request.progress) request.progress("searching pairs of links that may touch");
  const LinkBodies bodies = link_bodies(shapes.shapes_by_frame, bare.table);
  const std::vector<LinkPair> pairs = judge_pairs(bare.table, bodies);
  clear_covers(robot, shapes, bodies, pairs, request.budget.near, found.capsules);
  const auto name_of_link = link_names(bare);
  sections.push_back(
      {"collision", capsules_section(found, allowed_links_yaml(pairs, name_of_link))});
  std::vector<std::string> items = items_to_check(found, limits);
  for (std::string& sentence :
       pairs_to_check(read_back(joined(sections), request, kept).table, pairs, name_of_link))
    items.push_back(std::move(sentence));
  if (!items.empty()) sections.insert(sections.end() - 1, {"check", check_section(items)});
  result.text = fmt::format(
      "# Made by `morphe robot setup` from {}. What stands below a line that begins with `#:` is\n"
      "# made anew each time, unless somebody changed it: then it stays as it is.\n{}",
      request.urdf.filename().string(), joined(sections));
  if (!kept.empty())
    result.notes.push_back(fmt::format("kept because edited: {}", fmt::join(kept, ", ")));
  result.points = shapes.points;  // the frames of the URDF come first in the description
  // Kept sections may contradict others.
  const robot::RobotDescription made = read_back(result.text, request, kept);
  result.to_check = made.checks;
  result.derived = derived_frames(found, made, kept);
  return result;
}

}  // namespace morphe::setup
