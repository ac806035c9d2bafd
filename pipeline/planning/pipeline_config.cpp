#include "pipeline/planning/pipeline_config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>
#include <system_error>

#include "core/config/fields.hpp"
#include "core/files/given_files.hpp"
#include "core/files/sha256.hpp"
#include "core/motion/version.hpp"
#include "pipeline/planning/assumptions.hpp"
#include "pipeline/planning/input_names.hpp"

namespace morphe::planning {
namespace {

using Paths = std::vector<std::filesystem::path>;

/// Begin the settings that say which input is the config, always the first one, and which entry of
/// `robots` is meant, if it has several.
const std::string kConfigSetting = "config=", kRobotSetting = "robots=";

config::ConfigNode load_extended(const std::filesystem::path& file, Paths& files,
                                 const files::GivenFiles* given);

/// Returns the config named by the key `extends` of a config, or of an entry of its robots; nullopt
/// without this key. `files` are those read on the way here, and receives those that are read now.
std::optional<config::ConfigNode> load_base(const config::ConfigNode& node, Paths& files) {
  if (!node.has("extends")) return {};
  const config::ConfigNode extends = node["extends"];
  constexpr std::size_t kMaxExtendsDepth = 100;
  if (files.size() > kMaxExtendsDepth)
    extends.fail(fmt::format("more than {} configs extend one another", kMaxExtendsDepth));
  const std::filesystem::path base = files::located(node.folder() / extends.text(), node.given());
  for (const auto& known : files) {
    std::error_code ignored;
    if (known == base || (!node.given() && std::filesystem::equivalent(known, base, ignored)))
      extends.fail("names a config that itself extends this one");
  }
  return load_extended(base, files, node.given());
}

/// Loads a config, with omitted keys taken from those that it extends. Appends all to `files`.
config::ConfigNode load_extended(const std::filesystem::path& file, Paths& files,
                                 const files::GivenFiles* given) {
  config::ConfigNode node = config::ConfigNode::load(file, given);
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

/// Applies "a.b=value" settings.
void apply_settings(const std::vector<std::string>& settings, config::ConfigNode& node) {
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0 || setting.find('\n') != std::string::npos)
      throw InputError(fmt::format("--set {}: must have the form a.b=value, in one line", setting));
    node.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
}

/// Replaces absolute paths in options by the names that the files have in plans.h5.
void hide_paths(const config::ConfigNode& node, const InputNames& names, PipelineConfig& options) {
  const auto hide = [&](const config::ConfigNode& named, std::string& file) {
    if (std::filesystem::path(file).is_absolute()) file = names.without_paths(file, named.file());
  };
  hide(node["robot"]["file"], options.robot.file);
  if (options.dataset) hide(node["dataset"]["file"], options.dataset->file);
  if (!options.scene.file.empty()) hide(node["scene"]["file"], options.scene.file);
  for (std::size_t k = 0; k < options.scene.objects.size(); ++k)
    hide(node["scene"]["objects"].items()[k], options.scene.objects[k].file);
  if (options.scene.target.body)
    hide(node["scene"]["target"]["body"], options.scene.target.body->file);
}

/// Sets the inputs and settings of a config from its files, with names in place of paths.
void name_inputs(const config::ConfigNode& node, LoadedConfig& loaded) {
  InputNames names(loaded.files);
  names.hide(loaded.dataset);
  hide_paths(node, names, loaded.options);
  for (std::string& setting : loaded.settings)
    setting = names.without_paths(std::move(setting), loaded.files.front());
  loaded.inputs = names.read();
}

/// Loads the options of a config that was read from `files`, and the files that it names. Only a
/// config of the disk gets inputs and settings.
LoadedConfig load(config::ConfigNode node, const Paths& files,
                  const std::vector<std::string>& settings, const Terms& terms) {
  const bool from_disk = !node.given();
  apply_settings(settings, node);
  LoadedConfig loaded;
  loaded.settings = settings;
  config::read_document(node, loaded.options);
  if (changes_placement(settings)) loaded.options.placement.found_by.reset();
  if (from_disk) add_custom_terms(node, terms, loaded.options.map);

  const robot::RobotDescription robot =
      robot::load_robot(node["robot"]["file"].folder() / loaded.options.robot.file, node.given());
  loaded.robot = robot::Robot(robot.table);
  if (node.has("scene")) scene::load_scene_files(loaded.options.scene, node["scene"]);
  for (const Paths& own : {files, robot.files, loaded.options.scene.files})
    loaded.files.insert(loaded.files.end(), own.begin(), own.end());
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
  if (from_disk) name_inputs(node, loaded);
  loaded.assumptions = config_assumptions(loaded.options, robot.assumed, loaded.settings);
  const std::string forbidden =
      forbidden_assumption(loaded.options.must_be_known, loaded.assumptions);
  if (!forbidden.empty()) node["must_be_known"].fail(forbidden);
  loaded.effective = config::write_options(loaded.options);
  if (from_disk)
    loaded.settings.insert(loaded.settings.begin(), kConfigSetting + loaded.inputs.front().path);
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
  const config::ConfigNode node = load_extended(file, files, nullptr);
  if (node.has("robots"))
    node["robots"].fail("lists several robots; this command needs the config of one robot");
  return load(node, files, settings, terms);
}

namespace {

/// What load_robots() is to load: from the disk or given files, all robots or one.
struct LoadRequest {
  const std::vector<std::string>& settings;
  const Terms& terms;
  const files::GivenFiles* given = nullptr;
  std::optional<std::string> only;  ///< the name of the one robot
};

std::vector<RobotConfig> load_requested(const std::filesystem::path& file,
                                        const LoadRequest& request) {
  Paths files{files::located(file, request.given)};
  config::ConfigNode own = config::ConfigNode::load(file, request.given);
  std::optional<config::ConfigNode> base = load_base(own, files);
  const bool here = own.has("robots");
  if (!here && !(base && base->has("robots"))) {
    if (base) own.extend(*base);
    return {{"", load(own, files, request.settings, request.terms)}};
  }
  const config::ConfigNode robots_node = (here ? own : *base)["robots"];
  const config::ConfigNode list = robots_node.copy_as_document();
  if (list.items().empty()) list.fail("must list at least one robot");
  own.erase("robots");
  own.erase("extends");
  if (base) base->erase("robots");
  std::vector<RobotConfig> robots;
  for (const config::ConfigNode& entry : list.items()) {
    if (request.only && entry.has("name") && entry["name"].text() != *request.only) continue;
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
    robots.push_back({name, load(node, robot_files, request.settings, request.terms)});
    std::vector<std::string>& said = robots.back().loaded.settings;
    if (!request.given) said.insert(said.begin() + 1, kRobotSetting + name);
  }
  return robots;
}

}  // namespace

std::vector<RobotConfig> load_robots(const std::filesystem::path& file,
                                     const std::vector<std::string>& settings, const Terms& terms) {
  return load_requested(file, {settings, terms, nullptr, std::nullopt});
}

LoadedConfig reload_config(const PlanFileHeader& header) {
  std::vector<std::string> settings = header.settings;
  if (settings.empty() || !settings.front().starts_with(kConfigSetting))
    throw InputError(
        fmt::format("/@settings: does not begin with {}PATH (files of earlier versions have no "
                    "settings): plan again",
                    kConfigSetting));
  const std::string config = settings.front().substr(kConfigSetting.size());
  settings.erase(settings.begin());
  files::GivenFiles given("/inputs");
  for (const PlanFileHeader::Input& input : header.inputs) given.add(input.path, input.text);
  std::string name;
  if (!settings.empty() && settings.front().starts_with(kRobotSetting)) {
    name = settings.front().substr(kRobotSetting.size());
    settings.erase(settings.begin());
  }
  std::vector<RobotConfig> robots = load_requested(config, {settings, {}, &given, name});
  if (robots.size() != 1 || robots.front().name != name)
    throw InputError(fmt::format("/@settings: the config has no robot '{}'", name));
  LoadedConfig loaded = std::move(robots.front().loaded);
  loaded.inputs = header.inputs;
  loaded.settings = header.settings;
  return loaded;
}

PlanFileHeader header_of(const LoadedConfig& config, const std::string& dataset_sha256) {
  PlanFileHeader header;
  header.config = config.effective;
  header.config_sha256 = files::sha256(config.effective);
  header.dataset_sha256 = dataset_sha256;
  header.software = software();
  header.built_with = built_with();
  header.inputs = config.inputs;
  header.settings = config.settings;
  header.assumptions = config.assumptions;
  return header;
}

}  // namespace morphe::planning
