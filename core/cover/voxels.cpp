#include "core/cover/voxels.hpp"

#include <algorithm>
#include <cmath>

#include "core/cover/constants.hpp"

namespace morphe::cover {
namespace {

/// Computes d[i] = min_j (i - j)² + f[j] (Felzenszwalb, Huttenlocher); v [n], z [n + 1]: scratch.
void lower_envelope(const std::vector<double>& f, std::vector<double>& d, std::vector<int>& v,
                    std::vector<double>& z) {
  int k = -1;
  for (int q = 0; q < std::ssize(f); ++q) {
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
  int parabola = 0;
  for (int q = 0; q < std::ssize(f); ++q) {
    while (z[parabola + 1] < q) ++parabola;
    const int p = v[parabola];
    d[q] = (q - p) * (q - p) + f[p];
  }
}

/// Replaces `squares`, 0 on the surface and infinity elsewhere, by squared distances [voxels²].
void distance_transform(const Voxels& voxels, std::vector<double>& squares) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    const int length = voxels.count[axis];
    std::vector<double> row(length), out(length), z(length + 1);
    std::vector<int> v(length);
    for (int i = 0; i < voxels.count[u]; ++i) {
      for (int k = 0; k < voxels.count[w]; ++k) {
        Eigen::Vector3i voxel;
        voxel[u] = i;
        voxel[w] = k;
        const auto cell = [&](int j) {
          voxel[axis] = j;
          return voxels.index(voxel.x(), voxel.y(), voxel.z());
        };
        for (int j = 0; j < length; ++j) row[j] = squares[cell(j)];
        lower_envelope(row, out, v, z);
        for (int j = 0; j < length; ++j) squares[cell(j)] = out[j];
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
    const Eigen::Vector3i voxel = open.back();
    open.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Eigen::Vector3i next = voxel;
        next[axis] += side;
        if (next[axis] < 0 || next[axis] >= voxels.count[axis]) continue;
        const std::ptrdiff_t cell = voxels.index(next.x(), next.y(), next.z());
        if (!voxels.inside[cell] || on_surface[cell]) continue;
        voxels.inside[cell] = 0;
        open.push_back(next);
      }
    }
  }
}

}  // namespace

double Voxels::outside_distance(const Vec3& point) const {
  const Vec3 p = (point - origin) / step_m;
  Eigen::Vector3i cell;
  for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(std::clamp(p[k], 0.0, count[k] - 1.0));
  const std::ptrdiff_t cell_index = index(cell.x(), cell.y(), cell.z());
  const double beyond = step_m * (p - p.cwiseMax(0.0).cwiseMin(count.cast<double>())).norm();
  return beyond + (inside[cell_index] ? 0.0 : distance[cell_index]);
}

Voxels voxels_of(const std::vector<Vec3>& surface, int cells) {
  Voxels voxels;
  Vec3 lowest = surface.front(), highest = lowest;
  for (const Vec3& point : surface) {
    lowest = lowest.cwiseMin(point);
    highest = highest.cwiseMax(point);
  }
  voxels.step_m = std::max((highest - lowest).maxCoeff() / cells, kMinStep_m);
  for (int k = 0; k < 3; ++k) {
    voxels.count[k] =
        static_cast<int>((highest[k] - lowest[k]) / voxels.step_m) + 1 + 2 * kPaddingCells;
  }
  voxels.origin = lowest - Vec3::Constant(kPaddingCells * voxels.step_m);
  std::vector<std::uint8_t> on_surface(voxels.count.prod(), 0);
  for (const Vec3& point : surface) {
    const Eigen::Vector3i voxel = ((point - voxels.origin) / voxels.step_m).cast<int>();
    on_surface[voxels.index(voxel.x(), voxel.y(), voxel.z())] = 1;
  }
  flood_fill_outside(voxels, on_surface);
  std::vector<double> squares;
  for (const std::uint8_t on : on_surface) squares.push_back(on ? 0 : kInfinity);
  distance_transform(voxels, squares);
  for (const double square : squares)
    voxels.distance.push_back(static_cast<float>(voxels.step_m * std::sqrt(square)));
  return voxels;
}

}  // namespace morphe::cover
