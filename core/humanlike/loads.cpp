#include "core/humanlike/loads.hpp"

#include <algorithm>
#include <cmath>

#include "core/robot/tree.hpp"

namespace morphe::humanlike {
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
  points_added_ = angles_added_ = 0;
  on_frame.assign(frames, Load{});
}

void Loads::add_point(int frame, const Vec3& x, const Vec3& goal, double weight, bool to_be_met) {
  const Vec3 force = 2 * weight * (x - goal);
  value += weight * (x - goal).squaredNorm();
  Vec3 predicted = force;
  if (curvature == Curvature::exact) {
    if (points.size() == points_added_) {
      PointMemory& added = points.emplace_back();
      if (!to_be_met) added.multiplier_force = force;
    }
    PointMemory& memory = points[points_added_++];
    predicted = memory.multiplier_force;
    memory = {frame, x, force, 2 * weight, predicted};
  }
  add_force(frame, x, force, predicted, 2 * weight);
}

void Loads::add_force(int frame, const Vec3& x, const Vec3& force, const Vec3& predicted,
                      double mass) {
  if (frame < 0) return;
  Load& load = on_frame[frame];
  load.force += force;
  load.moment += x.cross(force);
  if (curvature == Curvature::none) return;
  const Vec3 mass_moment = mass * x;
  load.mass += mass;
  load.mass_moment += mass_moment;
  load.inertia.noalias() -= mass_moment * x.transpose();
  load.inertia.diagonal().array() += mass_moment.dot(x);
  if (curvature != Curvature::exact) return;
  load.multiplier_force += predicted;
  load.geometric_stiffness.noalias() += x * predicted.transpose();
  load.geometric_stiffness.diagonal().array() -= x.dot(predicted);
}

void Loads::add_rotation(int frame, const Vec3& gradient, const Eigen::Matrix3d& hessian) {
  if (frame < 0) return;
  Load& load = on_frame[frame];
  load.moment += gradient;
  if (curvature == Curvature::none) return;
  load.inertia += hessian;
  // Composed rotations differ from the sum of their vectors by half the cross product of these.
  if (curvature == Curvature::exact) load.geometric_stiffness -= cross_matrix(0.5 * gradient);
}

void Loads::add_angle(int frame, const Quat& current, const Quat& goal, double weight,
                      double smoothing) {
  if (angles.size() == angles_added_) angles.emplace_back();
  AngleMemory& memory = angles[angles_added_++];
  const Quat error = current * goal.conjugate();
  const double sine = error.vec().norm(), cosine = std::abs(error.w());
  const double half = std::atan2(sine, cosine);
  const double smooth = std::sqrt(half * half + smoothing * smoothing);
  const Vec3 axis =
      sine > 0 ? Vec3(std::copysign(1 / sine, error.w()) * error.vec()) : Vec3::UnitZ();
  value += weight * smooth;
  const Vec3 gradient = (0.5 * weight * half / smooth) * axis;
  if (curvature == Curvature::none) return add_rotation(frame, gradient, Eigen::Matrix3d::Zero());
  double along = 1;
  if (curvature == Curvature::exact) {
    const Vec3 half_vector = half * axis;
    if (memory.smooth > 0) {
      const double before = memory.smooth;
      const double stretch = memory.half.dot(half_vector - memory.half) / (before * before);
      memory.dual = half_vector / before - stretch * memory.dual;
      const double norm = memory.dual.norm();
      if (norm > 1) memory.dual /= norm;
    }
    memory.half = half_vector;
    memory.smooth = smooth;
    along = 1 - std::max(0.0, memory.dual.dot(axis)) * half / smooth;
  }
  // The limit of half * cosine / sine at 0 is 1: there both curvatures are equal.
  const double across = sine > 1e-6 ? half * cosine / sine : 1;
  const double scale = 0.25 * weight / smooth;
  Eigen::Matrix3d hessian = (scale * (along - across)) * (axis * axis.transpose());
  hessian.diagonal().array() += scale * across;
  add_rotation(frame, gradient, hessian);
}

void Loads::add_direction(int frame, const Vec3& current, const Vec3& goal, double weight) {
  value += weight * (current - goal).squaredNorm();
  const Vec3& other = curvature == Curvature::exact ? goal : current;
  Eigen::Matrix3d hessian = -weight * (current * other.transpose() + other * current.transpose());
  hessian.diagonal().array() += 2 * weight * current.dot(other);
  add_rotation(frame, -2 * weight * current.cross(goal), hessian);
}

void predict_multiplier_forces(const RobotModel& robot, const JointVector& step, LoadSweep& sweep,
                               std::vector<PointMemory>& points) {
  sweep.displacement.resize(robot.frames.size());
  for (int i = 0; i < std::ssize(robot.frames); ++i) {
    const int above = sweep.parent_moving_frame[i], joint = robot.frames[i].joint;
    if (above >= 0) {
      sweep.displacement[i] = sweep.displacement[above];
    } else {
      sweep.displacement[i].setZero();
    }
    if (joint >= 0) sweep.displacement[i] += step[joint] * sweep.twist[i];
  }
  const bool has_offset = step.size() > std::ssize(robot.joint_names);
  for (PointMemory& point : points) {
    if (point.frame < 0) continue;
    const auto& twist = sweep.displacement[point.frame];
    Vec3 shift = twist.head<3>().cross(point.x) + twist.tail<3>();
    if (has_offset) shift -= step.tail<3>();
    point.multiplier_force = point.force + point.mass * shift;
  }
}

void add_derivatives(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                     Loads& loads, LoadSweep& sweep, solve::Quadratic& model) {
  sweep.twist.resize(robot.frames.size());
  sweep.parent_moving_frame.clear();
  for (int i = 0; i < std::ssize(robot.frames); ++i) {
    const RobotModel::Frame& frame = robot.frames[i];
    sweep.parent_moving_frame.push_back(robot::moving_frame_of(robot, frame.parent));
    if (frame.joint < 0) continue;
    const Pose& pose = base_from_frame[i];
    const Vec3 axis = frame.axis.z() == 1 ? Vec3(frame.ratio * pose.linear().col(2))
                                          : Vec3(frame.ratio * (pose.linear() * frame.axis));
    if (frame.prismatic) {
      sweep.twist[i] << Vec3::Zero(), axis;
    } else {
      sweep.twist[i] << axis, pose.translation().cross(axis);
    }
  }

  // An offset of the goals changes the terms as the opposite motion of every point does.
  const Eigen::Index joints = std::ssize(robot.joint_names);
  const bool has_offset = model.gradient.size() == joints + 3;
  const bool exact = loads.curvature == Curvature::exact;
  model.value += loads.value;
  for (auto i = std::ssize(robot.frames) - 1; i >= 0; --i) {
    const RobotModel::Frame& frame = robot.frames[i];
    const Load& load = loads.on_frame[i];
    if (frame.joint >= 0) {
      const Vec3 axis = sweep.twist[i].head<3>(), shift = sweep.twist[i].tail<3>();
      model.gradient[frame.joint] += axis.dot(load.moment) + shift.dot(load.force);
      if (loads.curvature != Curvature::none) {
        const Eigen::Index n = model.gradient.size();
        double* hessian = model.hessian.data();
        const int j = frame.joint;
        Eigen::Matrix<double, 6, 1> column;  // I_j S_j
        column << load.inertia * axis + load.mass_moment.cross(shift),
            axis.cross(load.mass_moment) + load.mass * shift;
        if (exact)
          column.head<3>() += load.geometric_stiffness * axis + shift.cross(load.multiplier_force);
        hessian[j * n + j] += sweep.twist[i].dot(column);
        if (has_offset) {
          model.hessian.block<3, 1>(joints, j) -= column.tail<3>();
          model.hessian.block<1, 3>(j, joints) -= column.tail<3>().transpose();
        }
        for (int k = sweep.parent_moving_frame[i]; k >= 0; k = sweep.parent_moving_frame[k]) {
          const auto& twist = sweep.twist[k];
          const int other = robot.frames[k].joint;
          const double product = twist.dot(column);
          hessian[j * n + other] += product;
          hessian[other * n + j] += product;
        }
      }
    }
    if (frame.parent >= 0) {
      loads.on_frame[frame.parent] += load;
    } else if (has_offset) {
      model.gradient.tail<3>() -= load.force;
      if (loads.curvature != Curvature::none)
        model.hessian.diagonal().tail<3>().array() += load.mass;
    }
  }
}

}  // namespace morphe::humanlike
