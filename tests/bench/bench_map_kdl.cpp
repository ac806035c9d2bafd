#include "tests/bench/bench_map_kdl.hpp"

#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

namespace morphe {
namespace {

KDL::Frame frame_of(const Pose& pose) {
  const auto& r = pose.linear();
  const Vec3 p = pose.translation();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1),
                        r(2, 2)),
          KDL::Vector(p.x(), p.y(), p.z())};
}

/// Fixed frames are merged into the link before them; every joint turns about z.
KDL::Chain chain_of(const RobotModel& robot) {
  KDL::Chain chain;
  Pose link = Pose::Identity();
  bool turns = false;
  const auto finish = [&] {
    chain.addSegment(
        KDL::Segment(KDL::Joint(turns ? KDL::Joint::RotZ : KDL::Joint::None), frame_of(link)));
  };
  const RobotModel::Tip& tip = robot.tips.front();
  for (int i = 0; i <= tip.frame; ++i) {
    const RobotModel::Frame& frame = robot.frames[static_cast<std::size_t>(i)];
    link = link * frame.transform;
    if (frame.joint < 0) continue;
    finish();
    turns = true;
    link = Pose::Identity();
  }
  link = link * tip.transform;
  finish();
  return chain;
}

KDL::JntArray array_of(const JointVector& values) {
  KDL::JntArray array(static_cast<unsigned>(values.size()));
  array.data = values;
  return array;
}

}  // namespace

struct KdlArm::Solver {
  KDL::Chain chain;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::ChainIkSolverVel_pinv velocity;
  KDL::ChainIkSolverPos_NR_JL position;
  KDL::JntArray from, to;

  explicit Solver(const RobotModel& robot)
      : chain(chain_of(robot)),
        forward(chain),
        velocity(chain),
        position(chain, array_of(robot.lower), array_of(robot.upper), forward, velocity, 100, 1e-6),
        from(static_cast<unsigned>(robot.joints())),
        to(from) {}
};

KdlArm::KdlArm(const RobotModel& robot) : solver_(new Solver(robot)) {}
KdlArm::~KdlArm() { delete solver_; }

bool KdlArm::solve(const Pose& base_from_tip, JointVector& q) {
  solver_->from.data = q;
  const int result =
      solver_->position.CartToJnt(solver_->from, frame_of(base_from_tip), solver_->to);
  q = solver_->to.data;
  return result >= 0;
}

}  // namespace morphe
