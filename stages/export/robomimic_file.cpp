#include "stages/export/robomimic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>

#include "core/store/array_codec.hpp"
#include "core/store/flag_layout.hpp"
#include "core/store/hdf5_file.hpp"
#include "core/store/plan_layout.hpp"

namespace morphe::exports {
namespace {

/// Returns the actions scaled to [-1, 1].
JointRows scaled(const JointRows& actions, const JointVector& offset, const JointVector& scale) {
  JointRows result = actions.rowwise() - offset.transpose();
  // A joint with an empty range does not move. Rounding may lead slightly beyond a limit: clamped.
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    if (scale[j] > 0)
      result.col(j) = (result.col(j) / scale[j]).cwiseMax(-1.0).cwiseMin(1.0);
    else
      result.col(j).setZero();
  }
  return result;
}

void write(const store::Hdf5Group& group, const std::string& name, const JointRows& rows) {
  group.write(name, store::ArrayCodec<JointRows>::encode(rows));
}

/// Writes the phases of the transitions as segments.
void write_phases(const store::Hdf5Group& group, const std::vector<PhaseKind>& phases) {
  std::vector<std::string> names;
  std::vector<std::int32_t> begins, ends;
  for (int k = 0; k < std::ssize(phases); ++k) {
    if (k == 0 || phases[k] != phases[k - 1]) {
      names.emplace_back(name_of(phases[k]));
      begins.push_back(k);
      ends.push_back(k);
    }
    ends.back() = k + 1;
  }
  const store::Hdf5Group segments = group.create("phases");
  segments.set("names", names);
  segments.write<std::int32_t>("begin", {{begins.size()}, begins});
  segments.write<std::int32_t>("end", {{ends.size()}, ends});
}

std::vector<double> numbers(const JointVector& values) { return {values.begin(), values.end()}; }

}  // namespace

// Members are closed in reverse order: groups, then the file.
struct RobomimicWriter::State {
  JointVector offset, scale;
  store::Hdf5File file = {};
  store::Hdf5Group data = {};
  std::optional<store::Hdf5Group> grasps = {};
  std::size_t demos = 0;
  std::vector<std::string> train = {}, valid = {};  ///< names of the demonstrations
  Eigen::Index total = 0;
};

RobomimicWriter::RobomimicWriter(const files::AtomicFile& part, const RobomimicHeader& header)
    : state_(new State{0.5 * (header.lower + header.upper), 0.5 * (header.upper - header.lower)}) {
  State& s = *state_;
  s.file = store::Hdf5File::create(part.part());
  s.file.set_display_name(part.target());
  s.data = s.file.root().create("data");
  s.data.set("env_args", header.env_args);
  s.data.set("action_names", header.action_names);
  if (!header.not_verified.empty()) s.data.set("not_verified", header.not_verified);
  s.data.set("action_offset", numbers(s.offset));
  s.data.set("action_scale", numbers(s.scale));
}

RobomimicWriter::~RobomimicWriter() = default;

void RobomimicWriter::add(const RobomimicDemo& demo) {
  State& s = *state_;
  const Eigen::Index count = demo.actions.rows();
  const std::string name = fmt::format("demo_{}", s.demos);
  (demo.is_valid ? s.valid : s.train).push_back(name);
  store::LayoutWriter io(s.data.create(name));
  store::lay_out_flags(io, demo.flags);
  const store::Hdf5Group& group = io.current_group();
  group.set("num_samples", static_cast<std::int32_t>(count));
  group.set("plan", demo.plan);
  group.set("subject", demo.subject);
  group.set("task", demo.task);
  group.set("status", demo.status);
  write_phases(group, {demo.phase.begin(), demo.phase.begin() + count});
  write(group, "actions", scaled(demo.actions, s.offset, s.scale));
  write(group, "actions_abs", demo.actions);
  const store::Hdf5Group obs = group.create("obs"), next_obs = group.create("next_obs");
  for (const auto& [key, rows] : demo.observations) {
    assert(rows.rows() == count + 1);
    write(obs, key, rows.topRows(count));
    write(next_obs, key, rows.bottomRows(count));
  }
  std::vector<double> is_last(count, 0);
  is_last.back() = 1;
  group.write("rewards", store::ArrayCodec<std::vector<double>>::encode(is_last));
  group.write("dones", store::ArrayCodec<std::vector<double>>::encode(is_last));
  if (!demo.grasp.contacts.empty()) {
    if (!s.grasps) s.grasps = s.file.root().create("grasps");
    store::LayoutWriter layout(s.grasps->create(name), demo.joint_unit);
    store::lay_out_grasp(layout, demo.grasp);
  }
  ++s.demos;
  s.total += count;
}

void RobomimicWriter::finish() {
  State& s = *state_;
  s.data.set("total", static_cast<std::int32_t>(s.total));
  const store::Hdf5Group mask = s.file.root().create("mask");
  mask.write_strings("train", s.train);
  mask.write_strings("valid", s.valid);
  s.data = {};
  s.grasps.reset();
  s.file.close();
}

}  // namespace morphe::exports
