#include "core/humanlike/loads.hpp"

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

AngleMemory& Loads::next_angle() {
  if (angles.size() == angles_added_) angles.emplace_back();
  return angles[angles_added_++];
}

void Loads::add_point(int frame, const Vec3& x, const Vec3& goal, double weight, bool to_be_met) {
  const Vec3 force = 2 * weight * (x - goal);
  value += weight * (x - goal).squaredNorm();
  Vec3 promised = force;
  if (curvature == Curvature::exact) {
    if (points.size() == points_added_) {
      points.emplace_back();
      if (!to_be_met) points.back().multiplier_force = force;
    }
    PointMemory& memory = points[points_added_++];
    promised = memory.multiplier_force;
    memory = {frame, x, force, 2 * weight, promised};
  }
  add_force(frame, x, force, promised, 2 * weight);
}

void Loads::add_force(int frame, const Vec3& x, const Vec3& force, const Vec3& promised,
                      double mass) {
  if (frame < 0) return;
  Load& load = on_frame[frame];
  load.force += force;
  load.moment += x.cross(force);
  if (curvature == Curvature::none) return;
  const Vec3 first = mass * x;
  load.mass += mass;
  load.mass_moment += first;
  load.inertia.noalias() -= first * x.transpose();
  load.inertia.diagonal().array() += first.dot(x);
  if (curvature != Curvature::exact) return;
  load.multiplier_force += promised;
  load.geometric_stiffness.noalias() += x * promised.transpose();
  load.geometric_stiffness.diagonal().array() -= x.dot(promised);
}

void Loads::add_rotation(int frame, const Vec3& gradient, const Eigen::Matrix3d& hessian) {
  if (frame < 0) return;
  Load& load = on_frame[frame];
  load.moment += gradient;
  if (curvature == Curvature::none) return;
  load.inertia += hessian;
  // Rotation vectors do not add up when rotations are composed: half their cross product remains.
  if (curvature == Curvature::exact) load.geometric_stiffness -= cross_matrix(0.5 * gradient);
}

void predict_multiplier_forces(const RobotModel& robot, const JointVector& step, LoadSweep& sweep,
                               std::vector<PointMemory>& points) {
  const std::size_t frames = robot.frames.size();
  sweep.displacement.resize(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    const int above = sweep.parent_moving_frame[i], joint = robot.frames[i].joint;
    if (above >= 0) {
      sweep.displacement[i] = sweep.displacement[above];
    } else {
      sweep.displacement[i].setZero();
    }
    if (joint >= 0) sweep.displacement[i] += step[joint] * sweep.twist[i];
  }
  const bool offset = step.size() > static_cast<Eigen::Index>(robot.joints());
  for (PointMemory& point : points) {
    if (point.frame < 0) continue;
    const auto& twist = sweep.displacement[point.frame];
    Vec3 away = twist.head<3>().cross(point.x) + twist.tail<3>();
    if (offset) away -= step.tail<3>();
    point.multiplier_force = point.force + point.mass * away;
  }
}

void add_derivatives(const RobotModel& robot, const std::vector<Pose>& base_from_frame,
                     Loads& loads, LoadSweep& sweep, solve::Quadratic& model) {
  const std::size_t frames = robot.frames.size();
  sweep.twist.resize(frames);
  sweep.parent_moving_frame.resize(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    const RobotModel::Frame& frame = robot.frames[i];
    const auto parent = static_cast<std::size_t>(frame.parent);
    sweep.parent_moving_frame[i] = frame.parent < 0 ? -1
                                   : robot.frames[parent].joint >= 0
                                       ? frame.parent
                                       : sweep.parent_moving_frame[parent];
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

  // More variables than joints mean that an offset of the goals is optimised too, relative to which
  // every point moves.
  const auto joints = static_cast<Eigen::Index>(robot.joints());
  const bool offset = model.gradient.size() == joints + 3;
  const bool exact = loads.curvature == Curvature::exact;
  model.value += loads.value;
  for (std::size_t i = frames; i-- > 0;) {
    const RobotModel::Frame& frame = robot.frames[i];
    const Load& load = loads.on_frame[i];
    if (frame.joint >= 0) {
      const Vec3 axis = sweep.twist[i].head<3>(), shift = sweep.twist[i].tail<3>();
      model.gradient[frame.joint] += axis.dot(load.moment) + shift.dot(load.force);
      if (loads.curvature != Curvature::none) {
        const auto n = static_cast<int>(model.gradient.size());
        double* hessian = model.hessian.data();
        const int j = frame.joint;
        Eigen::Matrix<double, 6, 1> answer;
        answer << load.inertia * axis + load.mass_moment.cross(shift),
            axis.cross(load.mass_moment) + load.mass * shift;
        if (exact)
          answer.head<3>() += load.geometric_stiffness * axis + shift.cross(load.multiplier_force);
        hessian[j * n + j] += sweep.twist[i].dot(answer);
        if (offset) {
          model.hessian.block<3, 1>(joints, j) -= answer.tail<3>();
          model.hessian.block<1, 3>(j, joints) -= answer.tail<3>().transpose();
        }
        for (int k = sweep.parent_moving_frame[i]; k >= 0; k = sweep.parent_moving_frame[k]) {
          const auto& twist = sweep.twist[k];
          const int other = robot.frames[k].joint;
          const double product = twist.dot(answer);
          hessian[j * n + other] += product;
          hessian[other * n + j] += product;
        }
      }
    }
    if (frame.parent >= 0) {
      loads.on_frame[frame.parent] += load;
    } else if (offset) {
      model.gradient.tail<3>() -= load.force;
      if (loads.curvature != Curvature::none) {
        model.hessian.diagonal().tail<3>().array() += load.mass;
      }
    }
  }
}

}  // namespace morphe::humanlike
