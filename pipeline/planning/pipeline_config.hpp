#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"
#include "core/motion/residual_term.hpp"
#include "core/robot/files/description.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/planning/approach_options.hpp"
#include "pipeline/planning/parts_options.hpp"
#include "stages/check/check_path.hpp"
#include "stages/grasp/grasp_options.hpp"
#include "stages/map/hand_alignment.hpp"
#include "stages/map/map_options.hpp"
#include "stages/map/placement.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/repair/repair_options.hpp"
#include "stages/retime/retime.hpp"
#include "stages/scene/build_scene.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::planning {

/// A file named in the config, relative to the config's folder.
struct FileOption {
  std::string file;
};
template <class Fields>
void fields(Fields& f, FileOption& o) {
  f.required("file", o.file);
}

/// A config file, with one member per section.
struct PipelineConfig {
  std::optional<FileOption> dataset;  ///< demonstrations.h5 or a recordings manifest (.yaml)
  FileOption robot;
  reconstruct::HumanOptions human;
  map::PlacementOptions placement;
  map::HandOptions hand;
  scene::SceneOptions scene;
  std::uint64_t seed = 1;
  reconstruct::ReconstructOptions reconstruct;
  segment::SegmentOptions segment;
  map::MapOptions map;
  check::CheckOptions check;
  std::optional<grasp::GraspOptions> grasp;  ///< if absent: tips near the object, as in the paper
  repair::RepairOptions repair;
  retime::RetimeOptions retime;
  std::optional<ApproachOptions> approach;  ///< if absent: no approach and retreat
  std::optional<PartsOptions> split;        ///< if absent: no planning in parts
};
template <class Fields>
void fields(Fields& f, PipelineConfig& o) {
  f("dataset", o.dataset);
  f.required("robot", o.robot);
  f("human", o.human);
  f("placement", o.placement);
  f("hand", o.hand);
  f("scene", o.scene);
  f("seed", o.seed);
  f("reconstruct", o.reconstruct);
  f("segment", o.segment);
  f("map", o.map);
  f("check", o.check);
  f("grasp", o.grasp);
  f("repair", o.repair);
  f("retime", o.retime);
  f("approach", o.approach);
  f("split", o.split);
}

/// Returns the tolerances by which a plan is judged; with the section `grasp`, pads and links may
/// penetrate the target as specified there.
Tolerances tolerances_of(const PipelineConfig& config);

/// A config with all files that it names.
struct LoadedConfig {
  PipelineConfig options;
  robot::Robot robot;
  std::filesystem::path dataset;  ///< resolved against the config's folder; empty if not named
  std::string effective;          ///< YAML with every key, defaults included
  std::vector<PlanFileHeader::Input> inputs;  ///< the files that were read
};

/// Reads a config of one robot, applies "a.b=value" settings and loads the files that it names;
/// `terms` are the program's own terms for `map.custom_terms`. Throws InputError for invalid files
/// and values and for unknown keys.
LoadedConfig load_config(const std::filesystem::path& file,
                         const std::vector<std::string>& settings = {},
                         const std::vector<std::shared_ptr<const ResidualTerm>>& terms = {});

/// One of a config's `robots`; the name is "" for a config without this section, which has one
/// robot.
struct RobotConfig {
  std::string name;
  LoadedConfig loaded;
};

/// Reads the configs of a file with `robots`. An entry has a `name` and any section of a config
/// except `dataset`; omitted keys come from the rest of the file, then from the config that the
/// entry `extends`, if any (except its dataset), then from the file's own base. Settings apply to
/// each.
std::vector<RobotConfig> load_robots(
    const std::filesystem::path& file, const std::vector<std::string>& settings = {},
    const std::vector<std::shared_ptr<const ResidualTerm>>& terms = {});

/// Returns the header of a plans.h5 that is made with the config from that dataset.
PlanFileHeader header_of(const LoadedConfig& config, const std::string& dataset_sha256);

}  // namespace morphe::planning
