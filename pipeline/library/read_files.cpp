#include "core/files/data_files.hpp"
#include "core/robot/files/description.hpp"
#include "pipeline/library/morphe.hpp"
#include "pipeline/planning/plan_requirements.hpp"
#include "stages/import/import.hpp"

namespace morphe {

std::size_t import_recordings(const std::filesystem::path& recordings,
                              const std::filesystem::path& demonstrations) {
  imports::ImportRequest request;
  request.paths = {files::resolve_data_file(recordings)};
  return imports::write_demonstrations(request, demonstrations).entries.size();
}

RobotModel load_robot(const std::filesystem::path& description) {
  return robot::load_robot(files::resolve_data_file(description)).table;
}

verify::VerifyReport verify_plans(const std::filesystem::path& plans) {
  return verify::verify_file(plans, planning::plan_requirements);
}

}  // namespace morphe
