#include "core/cover/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphe::cover {
namespace {

constexpr int kPaddingCells = 3;  ///< empty voxels on each side

/// Computes d[i] = min_j (i - j)² + f[j], the lower envelope of parabolas (Felzenszwalb and
/// Huttenlocher).
void lower_envelope(const std::vector<double>& f, std::vector<double>& d, std::vector<int>& v,
                    std::vector<double>& z) {
  const int n = static_cast<int>(f.size());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  int k = -1;
  for (int q = 0; q < n; ++q) {
    if (std::isinf(f[q])) continue;
    double s = -kInfinity;
    while (k >= 0) {
      const int p = v[k];
      s = ((f[q] + q * q) - (f[p] + p * p)) / (2.0 * (q - p));
      if (s > z[k]) break;
      --k;
      s = -kInfinity;
    }
    ++k;
    v[k] = q;
    z[k] = s;
    z[k + 1] = kInfinity;
  }
  if (k < 0) {
    d = f;
    return;
  }
  int at = 0;
  for (int q = 0; q < n; ++q) {
    while (z[at + 1] < q) ++at;
    const int p = v[at];
    d[q] = (q - p) * (q - p) + f[p];
  }
}

/// Computes squared distances to the voxels of the surface, in voxels, one axis after the other.
void distance_transform(const Voxels& voxels, std::vector<double>& squares) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    const auto length = static_cast<std::size_t>(voxels.count[axis]);
    std::vector<double> row(length), out(length), z(length + 1);
    std::vector<int> v(length);
    for (int i = 0; i < voxels.count[u]; ++i) {
      for (int k = 0; k < voxels.count[w]; ++k) {
        Eigen::Vector3i at;
        at[u] = i;
        at[w] = k;
        const auto cell = [&](std::size_t j) {
          at[axis] = static_cast<int>(j);
          return voxels.index(at.x(), at.y(), at.z());
        };
        for (std::size_t j = 0; j < length; ++j) row[j] = squares[cell(j)];
        lower_envelope(row, out, v, z);
        for (std::size_t j = 0; j < length; ++j) squares[cell(j)] = out[j];
      }
    }
  }
}

/// Marks voxels as outside that can be reached from the grid's corner without crossing the surface.
void flood_fill_outside(Voxels& voxels, const std::vector<std::uint8_t>& on_surface) {
  voxels.inside.assign(on_surface.size(), 1);
  std::vector<Eigen::Vector3i> open = {Eigen::Vector3i::Zero()};
  voxels.inside[0] = 0;
  while (!open.empty()) {
    const Eigen::Vector3i at = open.back();
    open.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Eigen::Vector3i next = at;
        next[axis] += side;
        if (next[axis] < 0 || next[axis] >= voxels.count[axis]) continue;
        const std::size_t cell = voxels.index(next.x(), next.y(), next.z());
        if (!voxels.inside[cell] || on_surface[cell]) continue;
        voxels.inside[cell] = 0;
        open.push_back(next);
      }
    }
  }
}

}  // namespace

double Voxels::outside_distance(const Vec3& point) const {
  const Vec3 in = (point - origin) / step_m;
  Eigen::Vector3i cell;
  for (int k = 0; k < 3; ++k) {
    cell[k] = static_cast<int>(std::clamp(in[k], 0.0, static_cast<double>(count[k] - 1)));
  }
  const std::size_t at = index(cell.x(), cell.y(), cell.z());
  const double beyond = step_m * (in - in.cwiseMax(0.0).cwiseMin(count.cast<double>())).norm();
  return beyond + (inside[at] ? 0.0 : static_cast<double>(distance[at]));
}

Voxels voxels_of(const std::vector<Vec3>& surface, int along) {
  Voxels voxels;
  Vec3 least = surface.front(), most = least;
  for (const Vec3& point : surface) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  voxels.step_m = std::max((most - least).maxCoeff() / along, 1e-5);
  for (int k = 0; k < 3; ++k) {
    voxels.count[k] =
        static_cast<int>((most[k] - least[k]) / voxels.step_m) + 1 + 2 * kPaddingCells;
  }
  voxels.origin = least - Vec3::Constant(kPaddingCells * voxels.step_m);
  const auto cells = static_cast<std::size_t>(voxels.count.prod());
  std::vector<std::uint8_t> on_surface(cells, 0);
  for (const Vec3& point : surface) {
    const Eigen::Vector3i at = ((point - voxels.origin) / voxels.step_m).cast<int>();
    on_surface[voxels.index(at.x(), at.y(), at.z())] = 1;
  }
  flood_fill_outside(voxels, on_surface);
  std::vector<double> squares(cells, std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < cells; ++k) {
    if (on_surface[k]) squares[k] = 0;
  }
  distance_transform(voxels, squares);
  voxels.distance.resize(cells);
  for (std::size_t k = 0; k < cells; ++k) {
    voxels.distance[k] = static_cast<float>(voxels.step_m * std::sqrt(squares[k]));
  }
  return voxels;
}

}  // namespace morphe::cover
