#include "core/store/plan_file.hpp"

#include <fmt/format.h>

#include <charconv>

#include "core/files/atomic_file.hpp"
#include "core/store/consistency.hpp"
#include "core/store/hdf5_file.hpp"
#include "core/store/layout_contract.hpp"
#include "core/store/plan_header.hpp"
#include "core/store/plan_layout.hpp"
#include "core/store/robot_layout.hpp"

namespace morphe::store {
namespace {

constexpr const char* kPlanFormat = "morphe-plans";
constexpr int kPlanVersion = 3;

/// Parses a movement's name: "000" -> 0. Throws InputError for any other name.
int movement_index(const Hdf5Group& demonstration, const std::string& name) {
  int index = -1;
  const auto parsed = std::from_chars(name.data(), name.data() + name.size(), index);
  if (parsed.ec != std::errc() || fmt::format("{:03}", index) != name)
    demonstration.fail(name, "is not the number of a movement (000, 001, …)");
  return index;
}

}  // namespace

// Members are destroyed in reverse order: `output` after `file`, to remove an unfinished file.
struct PlanWriter::State {
  files::AtomicFile output;
  RobotModel robot;
  Hdf5File file;
  Hdf5Group plans;
};

PlanWriter::PlanWriter(const std::filesystem::path& path, const PlanFileHeader& header,
                       const RobotModel& robot)
    : PlanWriter(path, header, robot, files::real_disk()) {}

PlanWriter::PlanWriter(const std::filesystem::path& path, const PlanFileHeader& header,
                       const RobotModel& robot, files::Disk& disk)
    : state_(new State{files::AtomicFile(path, disk), robot, {}, {}}) {
  state_->file = Hdf5File::create(state_->output.part(), disk);
  state_->file.set_display_name(path);
  const Hdf5Group root = state_->file.root();
  write_format(root, kPlanFormat, kPlanVersion);
  write_plan_header(state_->file.root(), header, robot.name);
  LayoutWriter io(root.create("robot"), joint_unit(robot.has_prismatic_joint()));
  io.current_group().throw_if_fault(inconsistency(robot));
  lay_out_robot(io, robot);
  state_->plans = root.create("plans");
}

PlanWriter::~PlanWriter() = default;

void PlanWriter::add(const Plan& plan) {
  const std::string movement = fmt::format("{:03}", plan.movement.index);
  const std::string fault = inconsistency(plan, state_->robot);
  if (!fault.empty())
    state_->plans.throw_if_fault(fmt::format("{}/{}/{}", plan.demonstration, movement, fault));
  const Hdf5Group& plans = state_->plans;
  const std::string& name = plan.demonstration;
  const bool exists = !name.empty() && plans.has(name);
  const Hdf5Group demonstration = exists ? plans.open(name) : plans.create(name);
  LayoutWriter io(demonstration.create(movement), joint_unit(state_->robot.has_prismatic_joint()));
  lay_out_plan(io, plan);
  state_->file.expect_written();
}

void PlanWriter::finish() {
  state_->plans = {};
  state_->file.close();
  state_->output.commit();
}

struct PlanReader::State {
  Hdf5File file;
  Hdf5Group plans;
};

PlanReader::PlanReader(const std::filesystem::path& path) : state_(new State) {
  state_->file = Hdf5File::open(path);
  const Hdf5Group root = state_->file.root();
  check_format(root, kPlanFormat, kPlanVersion);
  header_ = read_plan_header(state_->file.root());
  LayoutReader io(root.open("robot"));
  lay_out_robot(io, robot_);
  io.current_group().throw_if_fault(inconsistency(robot_));
  state_->plans = root.open("plans");
  for (const std::string& demonstration : state_->plans.children()) {
    const Hdf5Group group = state_->plans.open(demonstration);
    for (const std::string& movement : group.children()) {
      movement_index(group, movement);  // throws if the name is not valid
      paths_.push_back(fmt::format("{}/{}", demonstration, movement));
    }
  }
}

PlanReader::~PlanReader() = default;

std::pair<std::string, std::string> PlanReader::names_of(std::size_t index) const {
  const std::string& path = paths_.at(index);
  const std::size_t slash = path.find('/');
  return {path.substr(0, slash), path.substr(slash + 1)};
}

std::vector<std::string> PlanReader::contract_faults() const {
  std::vector<std::string> faults;
  const std::string joints = joint_unit(robot_.has_prismatic_joint());
  LayoutContract root(state_->file.root(), "", joints, faults);
  root.attribute("format", std::string(kPlanFormat));
  root.attribute("version", kPlanVersion);
  compare_plan_header(root, header_, robot_.name);
  const Hdf5Group file = state_->file.root();
  std::string named;
  if (file.has_attribute("robot")) file.get("robot", named);
  if (named != robot_.name)
    root.fault("@robot", fmt::format("is '{}', not '{}'", named, robot_.name));
  root.group("robot", [&](LayoutContract& in) { lay_out_robot(in, robot_); });
  root.group("plans", [](LayoutContract& plans) {
    for (const std::string& name : plans.current_group().children()) {
      plans.group(name, [](LayoutContract& demonstration) {
        const std::vector<std::string> movements = demonstration.current_group().children();
        for (const std::string& movement : movements) demonstration.accept(movement);
        if (movements.empty()) demonstration.fault("000", "is missing");
      });
    }
  });
  root.finish();
  return faults;
}

std::vector<std::string> PlanReader::contract_faults(std::size_t index, const Plan& plan) const {
  const auto [demonstration, movement] = names_of(index);
  std::vector<std::string> faults;
  LayoutContract io(state_->plans.open(demonstration).open(movement), "",
                    joint_unit(robot_.has_prismatic_joint()), faults);
  lay_out_plan(io, plan);
  io.finish();
  return faults;
}

Plan PlanReader::read(std::size_t index) const {
  const auto [name, movement] = names_of(index);
  Plan plan;
  plan.demonstration = name;
  const Hdf5Group demonstration = state_->plans.open(name);
  plan.movement.index = movement_index(demonstration, movement);
  LayoutReader io(demonstration.open(movement));
  lay_out_plan(io, plan);
  io.current_group().throw_if_fault(inconsistency(plan, robot_));
  return plan;
}

}  // namespace morphe::store
