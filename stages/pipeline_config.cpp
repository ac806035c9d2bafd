#include "stages/pipeline_config.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "pipeline/config/fields.hpp"

namespace morphe {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be read", file.string()));
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The files a run was made from, named relative to the deepest folder that holds them all.
std::vector<PlanFileHeader::Input> collect(std::vector<std::filesystem::path> files) {
  for (auto& file : files) file = std::filesystem::weakly_canonical(file);
  std::filesystem::path common = files.front().parent_path();
  for (const auto& file : files) {
    while (file.lexically_relative(common).string().starts_with(".."))
      common = common.parent_path();
  }
  std::vector<PlanFileHeader::Input> inputs;
  for (const auto& file : files) {
    inputs.push_back({file.lexically_relative(common).generic_string(), text_of(file)});
  }
  return inputs;
}

}  // namespace

LoadedConfig load_config(const std::filesystem::path& file,
                         const std::vector<std::string>& settings) {
  ConfigNode node = ConfigNode::load(file);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError(fmt::format("--set {}: needs a.b=value", setting));
    }
    node.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
  LoadedConfig loaded;
  read_options(node, loaded.options);
  node.expect_all_read();

  std::vector<std::filesystem::path> files{file};
  const RobotDescription robot = load_robot(node.folder() / loaded.options.robot.file);
  loaded.robot = robot.table;
  files.insert(files.end(), robot.files.begin(), robot.files.end());
  if (!loaded.options.scene.file.empty()) {
    load_scene_file(loaded.options.scene, node.folder());
    files.push_back(node.folder() / loaded.options.scene.file);
  }
  if (loaded.options.dataset) loaded.dataset = node.folder() / loaded.options.dataset->file;
  make_objective(loaded.options.map, loaded.robot);  // the posture's joints exist
  loaded.effective = write_options(loaded.options);
  loaded.inputs = collect(std::move(files));
  return loaded;
}

}  // namespace morphe
