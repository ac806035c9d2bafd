#include "core/store/bytes.hpp"

#include "core/store/assumption_layout.hpp"
#include "core/store/bytes_layout.hpp"
#include "core/store/demonstration_layout.hpp"
#include "core/store/plan_layout.hpp"
#include "core/store/robot_layout.hpp"

namespace morphe::store {
namespace {

/// Lays out a plan and its position in the file, which HDF5 stores in the names of groups.
template <class Io, class T>
void lay_out_named_plan(Io& io, T& plan) {
  io.attribute("demonstration", plan.demonstration);
  io.attribute("movement", plan.movement.index);
  lay_out_plan(io, plan);
}

template <class Io, class T>
void lay_out_header(Io& io, T& header) {
  using Input = PlanFileHeader::Input;
  io.attribute("config", header.config);
  io.attribute("config_sha256", header.config_sha256);
  io.attribute("dataset_sha256", header.dataset_sha256);
  io.attribute("software", header.software);
  io.attribute("built_with", header.built_with);
  io.column("path", header.inputs, &Input::path, {});
  io.column("text", header.inputs, &Input::text, {});
  io.attribute("settings", header.settings);
  lay_out_assumptions(io, header.assumptions);
}

template <class Layout>
std::string serialize(const Layout& layout) {
  std::string bytes;
  BytesWriter io(bytes);
  layout(io);
  return bytes;
}

template <class T, class Layout>
T restore(std::string_view bytes, const Layout& layout) {
  T value;
  BytesReader io(bytes);
  layout(io, value);
  io.expect_end();
  return value;
}

}  // namespace

std::string bytes_of(const Plan& plan) {
  return serialize([&](BytesWriter& io) { lay_out_named_plan(io, plan); });
}

std::string bytes_of(const Demonstration& demonstration) {
  return serialize([&](BytesWriter& io) {
    io.attribute("name", demonstration.name);
    lay_out_demonstration(io, demonstration);
  });
}

std::string bytes_of(const RobotModel& robot) {
  return serialize([&](BytesWriter& io) { lay_out_robot(io, robot); });
}

std::string bytes_of(const SceneObject& object) {
  return serialize([&](BytesWriter& io) {
    io.attribute("name", object.name);
    lay_out_object(io, object, "world");
  });
}

std::string bytes_of(const PlanFileHeader& header) {
  return serialize([&](BytesWriter& io) { lay_out_header(io, header); });
}

Plan plan_from_bytes(std::string_view bytes) {
  return restore<Plan>(bytes, [](BytesReader& io, Plan& plan) { lay_out_named_plan(io, plan); });
}

RobotModel robot_from_bytes(std::string_view bytes) {
  return restore<RobotModel>(bytes,
                             [](BytesReader& io, RobotModel& robot) { lay_out_robot(io, robot); });
}

PlanFileHeader header_from_bytes(std::string_view bytes) {
  return restore<PlanFileHeader>(
      bytes, [](BytesReader& io, PlanFileHeader& header) { lay_out_header(io, header); });
}

}  // namespace morphe::store
