#include "core/motion/input_error.hpp"
#include "core/store/bytes.hpp"
#include "core/store/consistency.hpp"
#include "core/store/demonstration_file.hpp"
#include "core/store/plan_file.hpp"
#include "core/store/sandbox_probe.hpp"
#include "targets.hpp"

namespace morphe::fuzz {
namespace {

/// What reading a journal comes to.
void read_bytes(std::string_view bytes) {
  const auto attempt = [&](const auto& read) {
    try {
      read();
    } catch (const InputError&) {
    }
  };
  RobotModel robot;
  attempt([&] { robot = store::robot_from_bytes(bytes); });
  attempt([&] { store::header_from_bytes(bytes); });
  attempt([&] { store::inconsistency(store::plan_from_bytes(bytes), robot); });
}

/// As every command reads them that is given a file of others.
void read_plans(std::string_view bytes) {
  const std::filesystem::path file = as_file(bytes, "plans.h5");
  store::probe_in_sandbox(file);
  const store::PlanReader reader(file);
  for (std::size_t i = 0; i < reader.size(); ++i) reader.read(i);
}

void read_demonstrations(std::string_view bytes) {
  const std::filesystem::path file = as_file(bytes, "demonstrations.h5");
  store::probe_in_sandbox(file);
  const store::DemonstrationReader reader(file);
  for (std::size_t i = 0; i < reader.size(); ++i) reader.read(i);
}

}  // namespace

std::vector<Target> store_targets() {
  return {{"bytes", read_bytes},
          {"plans", read_plans, true},
          {"demonstrations", read_demonstrations, true}};
}

}  // namespace morphe::fuzz
