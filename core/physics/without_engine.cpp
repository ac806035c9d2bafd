// Replaces the other sources of this folder in a build without MuJoCo.
#include "core/physics/state.hpp"

namespace morphe::physics {

struct State::Running {};

namespace {

[[noreturn]] void fail() { throw EngineError("this build has no MuJoCo"); }

}  // namespace

std::string engine_version() { return ""; }

Model::Model(const std::string&) : compiled_(nullptr, nullptr) { fail(); }
int Model::body(const std::string&) const { fail(); }
int Model::joint(const std::string&) const { fail(); }
int Model::geom(const std::string&) const { fail(); }
int Model::actuator(const std::string&) const { fail(); }
int Model::geom_count() const { fail(); }

State::State(const Model& model) : model_(&model) { fail(); }
State::~State() = default;
State::State(State&&) noexcept = default;
double State::time_s() const { fail(); }
void State::set_joint(int, double) { fail(); }
double State::joint(int) const { fail(); }
void State::set_body(int, const Pose&) { fail(); }
Pose State::body(int) const { fail(); }
void State::set_control(int, double) { fail(); }
void State::set_acceleration(int, double) { fail(); }
double State::commanded_force(int) const { fail(); }
double State::applied_force(int) const { fail(); }
void State::apply_force(int, const Vec3&) { fail(); }
void State::update_poses() { fail(); }
std::optional<std::string> State::step() { fail(); }
void State::contacts(std::vector<GeomContact>&) const { fail(); }
Snapshot State::snapshot() const { fail(); }
void State::restore(const Snapshot&) { fail(); }

}  // namespace morphe::physics
