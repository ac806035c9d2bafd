#include "pipeline/planning/pipeline_config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "core/config/fields.hpp"
#include "core/files/sha256.hpp"
#include "core/motion/version.hpp"
#include "pipeline/planning/assumptions.hpp"

namespace morphe::planning {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be read", file.string()));
  return {std::istreambuf_iterator<char>(stream), {}};
}

using Paths = std::vector<std::filesystem::path>;

/// Returns the deepest folder that contains all files. There must be at least one.
std::filesystem::path common_folder(const Paths& files) {
  std::filesystem::path common = files.front().parent_path();
  for (const auto& file : files) {
    while (file.lexically_relative(common).string().starts_with(".."))
      common = common.parent_path();
  }
  return common;
}

/// Returns the names and texts of the files from which a run was made. To hide their locations, the
/// files of each group are named relative to their deepest common folder, or by their file names if
/// that is the root. A name already in use gets a numbered folder.
std::vector<PlanFileHeader::Input> name_inputs(const std::vector<Paths>& groups) {
  std::vector<PlanFileHeader::Input> inputs;
  std::set<std::string> used_names;
  for (Paths files : groups) {
    for (auto& file : files) file = std::filesystem::absolute(file).lexically_normal();
    const std::filesystem::path common = common_folder(files);
    for (const auto& file : files) {
      const auto inside =
          common == common.root_path() ? file.filename() : file.lexically_relative(common);
      std::string name = inside.generic_string();
      for (int number = 2; !used_names.insert(name).second; ++number)
        name = fmt::format("{}/{}", number, inside.generic_string());
      inputs.push_back({name, text_of(file)});
    }
  }
  return inputs;
}

config::ConfigNode load_extended(const std::filesystem::path& file, Paths& files);

/// Returns the config named by the key `extends` of a config, or of an entry of its robots; nullopt
/// without this key. `files` are those read on the way here, and receives those that are read now.
std::optional<config::ConfigNode> load_base(const config::ConfigNode& node, Paths& files) {
  if (!node.has("extends")) return {};
  const config::ConfigNode extends = node["extends"];
  constexpr std::size_t kMaxExtendsDepth = 100;
  if (files.size() > kMaxExtendsDepth)
    extends.fail(fmt::format("more than {} configs extend one another", kMaxExtendsDepth));
  const std::filesystem::path base = node.folder() / extends.text();
  for (const auto& known : files) {
    if (std::filesystem::weakly_canonical(known) == std::filesystem::weakly_canonical(base)) {
      extends.fail("names a config that itself extends this one");
    }
  }
  return load_extended(base, files);
}

/// Loads a config, with omitted keys taken from those that it extends. Appends all to `files`.
config::ConfigNode load_extended(const std::filesystem::path& file, Paths& files) {
  config::ConfigNode node = config::ConfigNode::load(file);
  files.push_back(file);
  if (const auto base = load_base(node, files)) node.extend(*base);
  return node;
}

/// Returns the index of the joint named in a list entry; -1 for an empty name.
int named_joint(const config::ConfigNode& entry, const char* key, const RobotModel& robot) {
  if (!entry.has(key) || entry[key].text().empty()) return -1;
  const std::string joint = entry[key].text();
  const auto found = std::ranges::find(robot.joint_names, joint);
  if (found == robot.joint_names.end()) {
    entry[key].fail(fmt::format("robot {} has no actuated joint '{}'", robot.name, joint));
  }
  return static_cast<int>(found - robot.joint_names.begin());
}

/// Checks that joints named in `natural_posture` and `home` exist, and home is within the limits.
void check_joints(const config::ConfigNode& node, const LoadedConfig& loaded) {
  const RobotModel& robot = loaded.robot;
  if (node.has("map") && node["map"].has("natural_posture")) {
    for (const config::ConfigNode& entry : node["map"]["natural_posture"].items()) {
      named_joint(entry, "joint", robot);
      named_joint(entry, "follow", robot);
    }
  }
  if (!loaded.options.approach || !node["approach"].has("home")) return;
  const std::vector<config::ConfigNode> home = node["approach"]["home"].items();
  for (std::size_t k = 0; k < home.size(); ++k) {
    const int joint = named_joint(home[k], "joint", robot);
    const double value = loaded.options.approach->home[k].value;
    if (joint < 0 || value < robot.lower[joint] || value > robot.upper[joint]) {
      home[k]["value"].fail("is beyond the joint's limits");
    }
  }
}

/// Adds the terms that map.custom_terms names to the objective. All must be among `terms`.
void add_custom_terms(const config::ConfigNode& node,
                      const std::vector<std::shared_ptr<const ResidualTerm>>& terms,
                      map::MapOptions& options) {
  const std::string unknown =
      humanlike::resolve_custom_terms(terms, options.objective.get<humanlike::CustomTerms>());
  if (unknown.empty()) return;
  std::string known;
  for (const auto& term : terms) known += (known.empty() ? "" : ", ") + term->name();
  node["map"]["custom_terms"].fail(fmt::format("this program has no term '{}' (available: {})",
                                               unknown, known.empty() ? "none" : known));
}

/// Returns true if a setting changes the placement, so that no search has found it as it is.
bool changes_placement(const std::vector<std::string>& settings) {
  return std::ranges::any_of(settings, [](const std::string& setting) {
    return setting.starts_with("placement.rotation") ||
           setting.starts_with("placement.shoulder_offset");
  });
}

using Terms = std::vector<std::shared_ptr<const ResidualTerm>>;

/// Loads the options of a config that was read from `files`, and the files that it names.
LoadedConfig load(config::ConfigNode node, const Paths& files,
                  const std::vector<std::string>& settings, const Terms& terms) {
  // A file named by an absolute path is a group of its own; see name_inputs().
  std::vector<Paths> groups{files};
  const auto group_of = [&](const std::filesystem::path& named) -> Paths& {
    return named.is_absolute() ? groups.emplace_back() : groups.front();
  };
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError(fmt::format("--set {}: must have the form a.b=value", setting));
    }
    node.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
  LoadedConfig loaded;
  config::read_document(node, loaded.options);
  if (changes_placement(settings)) loaded.options.placement.found_by.reset();
  add_custom_terms(node, terms, loaded.options.map);

  const robot::RobotDescription robot =
      robot::load_robot(node["robot"]["file"].folder() / loaded.options.robot.file);
  loaded.robot = robot::Robot(robot.table);
  Paths& with_robot = group_of(loaded.options.robot.file);
  with_robot.insert(with_robot.end(), robot.files.begin(), robot.files.end());
  if (node.has("scene")) scene::load_scene_files(loaded.options.scene, node["scene"]);
  if (!loaded.options.scene.file.empty()) {
    group_of(loaded.options.scene.file)
        .push_back(node["scene"]["file"].folder() / loaded.options.scene.file);
  }
  if (loaded.options.dataset) {
    loaded.dataset = node["dataset"]["file"].folder() / loaded.options.dataset->file;
  }
  check_joints(node, loaded);
  if (loaded.options.map.natural_posture.empty()) {
    for (const robot::NaturalJoint& joint : robot.natural) {
      loaded.options.map.natural_posture.push_back({joint.joint, joint.follow, joint.value});
    }
  }
  if (loaded.options.split && !map::is_hand_only(loaded.robot)) {
    node["split"].fail("is only for hands without an arm: " + loaded.robot.name + " has an arm");
  }
  loaded.assumptions = config_assumptions(loaded.options, robot.assumed, settings);
  const std::string forbidden =
      forbidden_assumption(loaded.options.must_be_known, loaded.assumptions);
  if (!forbidden.empty()) node["must_be_known"].fail(forbidden);
  loaded.effective = config::write_options(loaded.options);
  loaded.inputs = name_inputs(groups);
  return loaded;
}

/// Returns the name of an entry of `robots`: a valid folder name that no earlier entry has.
std::string name_of_entry(const config::ConfigNode& entry,
                          const std::vector<RobotConfig>& earlier) {
  const config::ConfigNode node = entry["name"];
  std::string name = node.text();
  const bool plain = std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '+';
  });
  if (name.empty() || !plain) node.fail("may contain only letters, digits, '_', '-' and '+'");
  if (std::ranges::find(earlier, name, &RobotConfig::name) != earlier.end())
    node.fail("appears twice");
  return name;
}

}  // namespace

Tolerances tolerances_of(const PipelineConfig& config) {
  Tolerances tolerances = config.check.tolerances;
  if (config.grasp) {
    tolerances.max_penetration = config.grasp->max_penetration_m;
    tolerances.max_link_penetration = config.grasp->max_link_penetration_m;
  }
  return tolerances;
}

bool is_carried_by_palm(const PipelineConfig& config) {
  return config.grasp || config.scene.target.carried_by == scene::Carrier::palm;
}

LoadedConfig load_config(const std::filesystem::path& file,
                         const std::vector<std::string>& settings, const Terms& terms) {
  Paths files;
  const config::ConfigNode node = load_extended(file, files);
  if (node.has("robots"))
    node["robots"].fail("lists several robots; this command needs the config of one robot");
  return load(node, files, settings, terms);
}

std::vector<RobotConfig> load_robots(const std::filesystem::path& file,
                                     const std::vector<std::string>& settings, const Terms& terms) {
  Paths files{file};
  config::ConfigNode own = config::ConfigNode::load(file);
  std::optional<config::ConfigNode> base = load_base(own, files);
  const bool here = own.has("robots");
  if (!here && !(base && base->has("robots"))) {
    if (base) own.extend(*base);
    return {{"", load(own, files, settings, terms)}};
  }
  const config::ConfigNode robots_node = (here ? own : *base)["robots"];
  const config::ConfigNode list = robots_node.copy_as_document();
  if (list.items().empty()) list.fail("must list at least one robot");
  own.erase("robots");
  own.erase("extends");
  if (base) base->erase("robots");
  std::vector<RobotConfig> robots;
  for (const config::ConfigNode& entry : list.items()) {
    if (entry.has("dataset"))
      entry["dataset"].fail("is the same for all robots: put it beside `robots`");
    Paths robot_files = files;
    config::ConfigNode node = entry.copy_as_document();
    node.extend(own);
    if (std::optional<config::ConfigNode> extended = load_base(entry, robot_files)) {
      if (extended->has("robots")) entry["extends"].fail("names a config with its own `robots`");
      extended->erase("dataset");
      node.extend(*extended);
    }
    if (base) node.extend(*base);
    const std::string name = name_of_entry(node, robots);
    node.erase("name");
    node.erase("extends");
    robots.push_back({name, load(node, robot_files, settings, terms)});
  }
  return robots;
}

PlanFileHeader header_of(const LoadedConfig& config, const std::string& dataset_sha256) {
  return {config.effective,  files::sha256(config.effective),
          dataset_sha256,    software(),
          built_with(),      config.inputs,
          config.assumptions};
}

}  // namespace morphe::planning
