#include "pipeline/humanlike/loads.hpp"

namespace morphe {
namespace {

Eigen::Matrix3d cross_matrix(const Vec3& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

void Loads::reset(std::size_t frames, Curvature wanted) {
  curvature = wanted;
  value = 0;
  on_frame.assign(frames, Load{});
}

void Loads::add_force(int frame, const Vec3& x, const Vec3& force, double mass) {
  if (frame < 0) return;
  Load& load = on_frame[static_cast<std::size_t>(frame)];
  load.force += force;
  load.moment += x.cross(force);
  if (curvature == Curvature::none) return;
  const Vec3 first = mass * x;
  load.mass += mass;
  load.first += first;
  load.first_and_force += first;
  load.turning.noalias() -= first * x.transpose();
  double diagonal = first.dot(x);
  if (curvature == Curvature::exact) {
    load.first_and_force -= force;
    load.turning.noalias() += x * force.transpose();
    diagonal -= x.dot(force);
  }
  load.turning.diagonal().array() += diagonal;
}

void Loads::add_turn(int frame, const Vec3& gradient, const Eigen::Matrix3d& hessian) {
  if (frame < 0) return;
  Load& load = on_frame[static_cast<std::size_t>(frame)];
  load.moment += gradient;
  if (curvature == Curvature::none) return;
  load.turning += hessian;
  // Two turns one after the other are not the turn by their sum: half their cross product is left.
  if (curvature == Curvature::exact) load.turning -= cross_matrix(0.5 * gradient);
}

void add_derivatives(const RobotTable& robot, const std::vector<Pose>& base_from_frame,
                     Loads& loads, LoadSweep& sweep, Quadratic& model) {
  const std::size_t frames = robot.frames.size();
  sweep.twist.resize(frames);
  sweep.above.resize(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    const RobotTable::Frame& frame = robot.frames[i];
    const auto parent = static_cast<std::size_t>(frame.parent);
    sweep.above[i] = frame.parent < 0                  ? -1
                     : robot.frames[parent].joint >= 0 ? frame.parent
                                                       : sweep.above[parent];
    if (frame.joint < 0) continue;
    const Pose& pose = base_from_frame[i];
    const Vec3 axis = frame.axis.z() == 1 ? Vec3(frame.ratio * pose.linear().col(2))
                                          : Vec3(frame.ratio * (pose.linear() * frame.axis));
    sweep.twist[i] << axis, pose.translation().cross(axis);
  }

  // More variables than joints: an offset of the goals, against which every point moves.
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  const bool offset = model.gradient.size() == joints + 3;
  model.value += loads.value;
  for (std::size_t i = frames; i-- > 0;) {
    const RobotTable::Frame& frame = robot.frames[i];
    const Load& load = loads.on_frame[i];
    if (frame.joint >= 0) {
      const Vec3 axis = sweep.twist[i].head<3>(), shift = sweep.twist[i].tail<3>();
      model.gradient[frame.joint] += axis.dot(load.moment) + shift.dot(load.force);
      if (loads.curvature != Curvature::none) {
        Eigen::Matrix<double, 6, 1> answer;
        answer << load.turning * axis + load.first_and_force.cross(shift),
            axis.cross(load.first) + load.mass * shift;
        model.hessian(frame.joint, frame.joint) += sweep.twist[i].dot(answer);
        if (offset) {
          model.hessian.block<3, 1>(joints, frame.joint) -= answer.tail<3>();
          model.hessian.block<1, 3>(frame.joint, joints) -= answer.tail<3>().transpose();
        }
        for (int k = sweep.above[i]; k >= 0; k = sweep.above[static_cast<std::size_t>(k)]) {
          const int other = robot.frames[static_cast<std::size_t>(k)].joint;
          const double product = sweep.twist[static_cast<std::size_t>(k)].dot(answer);
          model.hessian(frame.joint, other) += product;
          model.hessian(other, frame.joint) += product;
        }
      }
    }
    if (frame.parent >= 0) {
      loads.on_frame[static_cast<std::size_t>(frame.parent)] += load;
    } else if (offset) {
      model.gradient.tail<3>() -= load.force;
      if (loads.curvature != Curvature::none) {
        model.hessian.diagonal().tail<3>().array() += load.mass;
      }
    }
  }
}

}  // namespace morphe
