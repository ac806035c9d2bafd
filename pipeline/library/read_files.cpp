#include "core/files/shipped.hpp"
#include "core/robot/files/description.hpp"
#include "pipeline/library/morphe.hpp"
#include "pipeline/planning/asked_of.hpp"
#include "stages/import/import.hpp"

namespace morphe {

std::size_t import_recordings(const std::filesystem::path& recordings,
                              const std::filesystem::path& demonstrations) {
  imports::ImportRequest request;
  request.paths = {files::here_or_shipped(recordings)};
  return imports::write_demonstrations(request, demonstrations).entries.size();
}

RobotTable load_robot(const std::filesystem::path& description) {
  return robot::load_robot(files::here_or_shipped(description)).table;
}

verify::VerifyReport verify_plans(const std::filesystem::path& plans) {
  return verify::verify_file(plans, planning::asked_of);
}

}  // namespace morphe
