#include "stages/simulate/trajectory_curve.hpp"

#include <algorithm>

#include "core/math/quintic.hpp"

namespace morphe::simulate {

void TrajectoryCurve::move_to(double since_start_s) {
  const std::vector<double>& time = trajectory_.time;
  const double time_s = std::min(time.front() + since_start_s, time[last_]);
  while (sample_ + 2 <= last_ && time[sample_ + 1] <= time_s) ++sample_;
  since_sample_s_ = time_s - time[sample_];
}

JointVector TrajectoryCurve::derivative(int order) const {
  JointVector out(trajectory_.position.cols());
  for (int j = 0; j < out.size(); ++j)
    out[j] = math::value_at(math::quintic_piece(trajectory_, sample_, j), since_sample_s_, order);
  return out;
}

}  // namespace morphe::simulate
