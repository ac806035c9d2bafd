#pragma once

#include <map>
#include <optional>
#include <vector>

#include "stages/import/audit/point_streams.hpp"

namespace morphe::imports {

/// The motion of each point from its previous seen sample to each of its samples, compared with its
/// motion in the steps around it. The median of seven steps follows every human motion, also one
/// that begins, turns or ends suddenly, because it takes a side; a position that is wrong in a few
/// rows leaves it unchanged.
struct StepTable {
  double period_s = 0;  ///< median time between rows
  /// [N, K] displacement minus the usual one, and the usual one of one period [m]. Unseen in the
  /// first sample of a point, in samples that are unseen, and after gaps of more than kMaxStepGap.
  Array2D<Vec3> residual, usual;
  std::vector<double> periods;  ///< [N * K] time since the previous seen sample [periods]
  std::vector<double> noise_m;  ///< [K] median length of all residuals [m]
  std::vector<double> large_m;  ///< [K] length that a tenth of the residuals exceeds [m]

  /// Returns true if the residual is an outlier among those of the point, in the whole recording
  /// and in the rows around.
  bool is_outlier(std::size_t row, std::size_t point) const;
  /// Returns true if no human motion and no usual noise explains the residual, also if the point
  /// does not return.
  bool is_far_outlier(std::size_t row, std::size_t point) const;
};

/// Computes the table of a stream; its period is 0 if the stream has fewer than kMinJudgedRows.
StepTable step_table(const PointStream& stream);

/// The step tables of a recording's streams, each computed when it is first asked for.
class StepTables {
 public:
  /// Returns the table of a stream; the reference is valid until clear().
  const StepTable& of(const PointStream& stream);
  /// Forgets all tables, because the recording has changed.
  void clear() { tables_.clear(); }

 private:
  std::map<PointStreamKind, StepTable> tables_;
};

/// Returns up to six other points that keep their distance from one, nearest first: markers of the
/// same plate, joints of the same bone.
std::vector<std::size_t> rigid_neighbours(const PointStream& stream, std::size_t point);

/// Returns the part of a residual that the point's rigid neighbours do not share; no value if fewer
/// than two of them were seen.
std::optional<Vec3> own_residual(const StepTable& steps, const std::vector<std::size_t>& neighbours,
                                 std::size_t row, std::size_t point);

}  // namespace morphe::imports
