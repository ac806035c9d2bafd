#include "core/physics/state.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "core/physics/engine.hpp"

namespace morphe::physics {
namespace {

std::vector<double> copied(const mjtNum* from, int count) { return {from, from + count}; }

}  // namespace

struct State::Running {
  mjData* data = nullptr;
  std::vector<int> compensated_dofs;  ///< degrees of freedom of hinges and slides
  std::vector<mjtNum> compensated_acceleration, inertial_force;  ///< [nv]
  ~Running() {
    if (data) mj_deleteData(data);
  }
};

State::State(const Model& model) : model_(&model), running_(std::make_unique<Running>()) {
  const mjModel& m = model.compiled();
  call_guarded([&] { running_->data = mj_makeData(&m); });
  if (!running_->data) throw EngineError("not enough memory for a simulation");
  for (int joint = 0; joint < m.njnt; ++joint) {
    if (m.jnt_type[joint] == mjJNT_HINGE || m.jnt_type[joint] == mjJNT_SLIDE)
      running_->compensated_dofs.push_back(m.jnt_dofadr[joint]);
  }
  running_->compensated_acceleration.assign(m.nv, 0);
  running_->inertial_force = running_->compensated_acceleration;
}

State::~State() = default;
State::State(State&&) noexcept = default;

double State::time_s() const { return running_->data->time; }

void State::set_joint(int joint, double value) {
  running_->data->qpos[model_->compiled().jnt_qposadr[joint]] = value;
}

double State::joint(int joint) const {
  return running_->data->qpos[model_->compiled().jnt_qposadr[joint]];
}

void State::set_body(int body, const Pose& pose) {
  const mjModel& m = model_->compiled();
  const int joint = m.body_jntadr[body];
  assert(joint >= 0 && m.jnt_type[joint] == mjJNT_FREE);
  const Quat rotation(pose.linear());
  mjtNum* const position = running_->data->qpos + m.jnt_qposadr[joint];
  std::ranges::copy(pose.translation(), position);
  std::ranges::copy(std::array{rotation.w(), rotation.x(), rotation.y(), rotation.z()},
                    position + 3);
  std::fill_n(running_->data->qvel + m.jnt_dofadr[joint], 6, 0.0);
}

Pose State::body(int body) const {
  const mjtNum* const x = running_->data->xpos + 3 * body;
  const mjtNum* const q = running_->data->xquat + 4 * body;
  return make_pose(Vec3(x[0], x[1], x[2]), Quat(q[0], q[1], q[2], q[3]));
}

void State::set_control(int actuator, double value) { running_->data->ctrl[actuator] = value; }

void State::set_acceleration(int joint, double value) {
  running_->compensated_acceleration[model_->compiled().jnt_dofadr[joint]] = value;
}

double State::commanded_force(int actuator) const {
  const mjModel& m = model_->compiled();
  const mjData& d = *running_->data;
  const mjtNum* const gain = m.actuator_gainprm + mjNGAIN * actuator;
  const mjtNum* const bias = m.actuator_biasprm + mjNBIAS * actuator;
  return gain[0] * d.ctrl[actuator] + bias[0] + bias[1] * d.actuator_length[actuator] +
         bias[2] * d.actuator_velocity[actuator];
}

double State::applied_force(int actuator) const {
  const mjModel& m = model_->compiled();
  const int dof = m.jnt_dofadr[m.actuator_trnid[2 * actuator]];
  return running_->data->actuator_force[actuator] + running_->data->qfrc_applied[dof];
}

void State::apply_force(int body, const Vec3& force) {
  std::ranges::copy(force, running_->data->xfrc_applied + 6 * body);
}

void State::update_poses() {
  call_guarded([&] { mj_forward(&model_->compiled(), running_->data); });
}

std::optional<std::string> State::step() {
  const mjModel& m = model_->compiled();
  mjData& d = *running_->data;
  const double before_s = d.time;
  const std::string warning = call_guarded([&] {
    mj_step1(&m, &d);
    mj_mulM(&m, &d, running_->inertial_force.data(), running_->compensated_acceleration.data());
    for (const int dof : running_->compensated_dofs)
      d.qfrc_applied[dof] = d.qfrc_bias[dof] + running_->inertial_force[dof];
    mj_step2(&m, &d);
  });
  if (!warning.empty()) return warning;
  // MuJoCo calls the handler only at the first warning of a kind, and counts further ones.
  for (int kind = 0; kind < mjNWARNING; ++kind) {
    if (d.warning[kind].number > 0) return mju_warningText(kind, d.warning[kind].lastinfo);
  }
  if (!(d.time > before_s)) return "the simulation became unstable and was reset by the engine";
  return std::nullopt;
}

void State::contacts(std::vector<GeomContact>& out) const {
  const mjModel& m = model_->compiled();
  const mjData& d = *running_->data;
  out.clear();
  for (int k = 0; k < d.ncon; ++k) {
    const mjContact& contact = d.contact[k];
    if (contact.exclude != 0 || contact.efc_address < 0) continue;
    std::array<mjtNum, 6> force{};
    mj_contactForce(&m, &d, k, force.data());
    out.push_back(
        {contact.geom1, contact.geom2, Vec3(contact.pos[0], contact.pos[1], contact.pos[2]),
         Vec3(contact.frame[0], contact.frame[1], contact.frame[2]), contact.dist, force[0]});
  }
}

Snapshot State::snapshot() const {
  const mjModel& m = model_->compiled();
  const mjData& d = *running_->data;
  return {d.time, copied(d.qpos, m.nq), copied(d.qvel, m.nv), copied(d.ctrl, m.nu),
          copied(d.qacc_warmstart, m.nv)};
}

void State::restore(const Snapshot& snapshot) {
  mjData& d = *running_->data;
  assert(std::ssize(snapshot.position) == model_->compiled().nq);
  d.time = snapshot.time_s;
  std::ranges::copy(snapshot.position, d.qpos);
  std::ranges::copy(snapshot.velocity, d.qvel);
  std::ranges::copy(snapshot.control, d.ctrl);
  std::ranges::copy(snapshot.acceleration, d.qacc_warmstart);
}

}  // namespace morphe::physics
