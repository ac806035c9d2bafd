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
#include "stages/import/audit/audit_options.hpp"
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
  imports::AuditOptions audit;
  reconstruct::ReconstructOptions reconstruct;
  segment::SegmentOptions segment;
  map::MapOptions map;
  check::CheckOptions check;
  std::optional<grasp::GraspOptions> grasp;  ///< absent: tips near the object, as in the paper
  repair::RepairOptions repair;
  retime::RetimeOptions retime;
  std::optional<ApproachOptions> approach;  ///< if absent: no approach and retreat
  std::optional<PartsOptions> split;        ///< if absent: no planning in parts
  /// Subjects that must not be assumed or inferred; otherwise a movement is not planned.
  std::vector<Knowable> must_be_known;
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
  f("audit", o.audit);
  f("reconstruct", o.reconstruct);
  f("segment", o.segment);
  f("map", o.map);
  f("check", o.check);
  f("grasp", o.grasp);
  f("repair", o.repair);
  f("retime", o.retime);
  f("approach", o.approach);
  f("split", o.split);
  f("must_be_known", o.must_be_known);
}

/// Returns the tolerances by which a plan is judged. With the section `grasp`, its values limit how
/// deep pads and links may penetrate the target.
Tolerances tolerances_of(const PipelineConfig& config);

/// Returns true if a target that is carried is attached to the palm: by `carried_by`, or because
/// the hand holds it with contacts.
bool is_carried_by_palm(const PipelineConfig& config);

/// A config of one robot, with the files that it names.
struct LoadedConfig {
  PipelineConfig options;
  robot::Robot robot;
  std::filesystem::path dataset;  ///< resolved against the config's folder; empty if not named
  std::string effective;          ///< YAML with every key, defaults included
  std::vector<PlanFileHeader::Input> inputs;  ///< the files that were read, as named in plans.h5
  std::vector<std::string> settings;          ///< as PlanFileHeader::settings
  std::vector<std::filesystem::path> files;   ///< the same files by the paths that were opened
  std::vector<Assumption> assumptions;        ///< config_assumptions()
};

/// Reads a config of one robot, applies "a.b=value" settings and loads the files that it names.
/// `terms` are terms that the calling program provides for `map.custom_terms`. Throws InputError
/// for invalid files and values, unknown keys, and a config with `robots`.
LoadedConfig load_config(const std::filesystem::path& file,
                         const std::vector<std::string>& settings = {},
                         const std::vector<std::shared_ptr<const ResidualTerm>>& terms = {});

/// The config of one entry of `robots`. The name is "" for a config without this section.
struct RobotConfig {
  std::string name;
  LoadedConfig loaded;
};

/// Reads the config of each robot of a file: of its `robots`, or of its one robot. An entry of
/// `robots` has a `name` and any section of a config except `dataset`. A key that it omits comes
/// from the first of these that has it:
///   1. the rest of the file
///   2. the config that the entry `extends`, without its dataset
///   3. the config that the file `extends`
/// Settings, terms and errors are those of load_config(), for each robot.
std::vector<RobotConfig> load_robots(
    const std::filesystem::path& file, const std::vector<std::string>& settings = {},
    const std::vector<std::shared_ptr<const ResidualTerm>>& terms = {});

/// Loads the config of a plans.h5 again, from the inputs and settings of its header alone; nothing
/// is read from the disk. Its `effective` is the header's config unless that was changed or another
/// version wrote it. Custom terms are not resolved. Throws InputError as load_config() does, with
/// files named as in /inputs, and for a file that is not among the inputs.
LoadedConfig reload_config(const PlanFileHeader& header);

/// Returns the header of a plans.h5 with plans made with the config from the dataset of this hash.
PlanFileHeader header_of(const LoadedConfig& config, const std::string& dataset_sha256);

}  // namespace morphe::planning
