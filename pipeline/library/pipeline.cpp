#include "core/files/data_files.hpp"
#include "core/files/sha256.hpp"
#include "pipeline/library/morphe.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/planning/verified_plan.hpp"

namespace morphe {

struct Pipeline::State {
  State(const std::filesystem::path& file, const std::vector<std::string>& settings,
        const std::vector<std::shared_ptr<const ResidualTerm>>& terms)
      : config(planning::load_config(files::resolve_data_file(file), settings, terms)) {}

  planning::LoadedConfig config;
  planning::PlanRequirements requirements = planning::requirements_of(config);
  planning::PlanningInputs planner{config.options, config.robot, nullptr, &requirements};
};

Pipeline::Pipeline(const std::filesystem::path& config, const std::vector<std::string>& settings,
                   const std::vector<std::shared_ptr<const ResidualTerm>>& terms)
    : state_(std::make_shared<State>(config, settings, terms)) {}

std::vector<Plan> Pipeline::plan(const Demonstration& demonstration) const {
  // Sums may depend on the alignment of rows in memory; a copy has the alignment that this
  // library's own data have.
  const Demonstration own = demonstration;
  return planning::plan_demonstration(state_->planner, own).plans;
}

PlanFileHeader Pipeline::header(const std::filesystem::path& demonstrations) const {
  return planning::header_of(state_->config, files::sha256_of_file(demonstrations));
}

const RobotModel& Pipeline::robot() const { return state_->config.robot; }

const std::filesystem::path& Pipeline::dataset() const { return state_->config.dataset; }

}  // namespace morphe
