#include "core/cover/voxels.hpp"

#include <algorithm>
#include <array>
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

/// Marks the voxels of points on a triangle, of which every other point has one within half a
/// voxel. Two neighbouring voxels on different sides of the surface are then never both unmarked:
/// the ball of half a voxel about any point between their centres lies in the two.
void mark(const Triangle& t, const Voxels& voxels, std::vector<std::uint8_t>& on_surface) {
  // The longest edge leads from a to b; the points lie in rows perpendicular to it.
  std::array<Vec3, 3> corner = {t.a, t.b, t.c};
  const auto length = [&](int k) { return (corner[(k + 1) % 3] - corner[k]).squaredNorm(); };
  const int longest =
      length(0) >= length(1) ? (length(0) >= length(2) ? 0 : 2) : (length(1) >= length(2) ? 1 : 2);
  std::ranges::rotate(corner, corner.begin() + longest);
  const auto& [a, b, c] = corner;
  const double spacing_m = kMarkSpacing_cells * voxels.step_m, square = (b - a).squaredNorm();
  const double foot = square > 0 ? std::clamp((c - a).dot(b - a) / square, 0.0, 1.0) : 0;
  const int rows = 1 + static_cast<int>((b - a).norm() / spacing_m);
  for (int row = 0; row <= rows; ++row) {
    const double share = static_cast<double>(row) / rows;
    const Vec3 begin = a + share * (b - a);
    const Vec3 end = share < foot ? Vec3(a + share / foot * (c - a))
                     : share < 1  ? Vec3(c + (share - foot) / (1 - foot) * (b - c))
                                  : b;
    const int steps = 1 + static_cast<int>((end - begin).norm() / spacing_m);
    for (int step = 0; step <= steps; ++step) {
      const std::ptrdiff_t cell = voxels.cell_of(begin + (end - begin) * step / steps);
      if (cell >= 0) on_surface[cell] = 1;
    }
  }
}

/// Calls visit(cell, next) for every voxel and each of its six neighbours.
template <class Visit>
void for_each_neighbour(const Voxels& voxels, Visit visit) {
  const Eigen::Vector3i& n = voxels.count;
  const std::array<std::ptrdiff_t, 3> stride = {1, n.x(),
                                                static_cast<std::ptrdiff_t>(n.x()) * n.y()};
  for (int z = 0; z < n.z(); ++z) {
    for (int y = 0; y < n.y(); ++y) {
      for (int x = 0; x < n.x(); ++x) {
        const std::ptrdiff_t cell = voxels.index(x, y, z);
        const Eigen::Vector3i at(x, y, z);
        for (int axis = 0; axis < 3; ++axis) {
          if (at[axis] > 0) visit(cell, cell - stride[axis]);
          if (at[axis] + 1 < n[axis]) visit(cell, cell + stride[axis]);
        }
      }
    }
  }
}

}  // namespace

std::vector<float> distances_to(const Voxels& voxels, const std::vector<std::uint8_t>& cells) {
  std::vector<double> squares;
  squares.reserve(cells.size());
  for (const std::uint8_t in : cells) squares.push_back(in ? 0 : kInfinity);
  distance_transform(voxels, squares);
  std::vector<float> distances;
  distances.reserve(cells.size());
  for (const double square : squares)
    distances.push_back(static_cast<float>(voxels.step_m * std::sqrt(square)));
  return distances;
}

std::vector<Vec3> points_inside(const Voxels& voxels) {
  std::vector<Vec3> inside;
  for (int z = 0; z < voxels.count.z(); ++z) {
    for (int y = 0; y < voxels.count.y(); ++y) {
      for (int x = 0; x < voxels.count.x(); ++x)
        if (voxels.inside[voxels.index(x, y, z)]) inside.push_back(voxels.centre(x, y, z));
    }
  }
  return inside;
}

double Voxels::outside_distance(const Vec3& point) const {
  const Vec3 p = (point - origin) / step_m;
  Eigen::Vector3i cell;
  for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(std::clamp(p[k], 0.0, count[k] - 1.0));
  const std::ptrdiff_t cell_index = index(cell.x(), cell.y(), cell.z());
  const double beyond = step_m * (p - p.cwiseMax(0.0).cwiseMin(count.cast<double>())).norm();
  return beyond + (inside[cell_index] ? 0.0 : distance[cell_index]);
}

Voxels voxels_of(const std::vector<Triangle>& surface, int cells, double padding_m) {
  Voxels voxels;
  Vec3 lowest = surface.front().a, highest = lowest;
  for (const Triangle& t : surface) {
    for (const Vec3& corner : {t.a, t.b, t.c}) {
      lowest = lowest.cwiseMin(corner);
      highest = highest.cwiseMax(corner);
    }
  }
  voxels.step_m = std::max((highest - lowest).maxCoeff() / cells, kMinStep_m);
  const int padding =
      std::max(kPaddingCells, 2 + static_cast<int>(std::ceil(padding_m / voxels.step_m)));
  voxels.padding_m = padding * voxels.step_m;
  for (int k = 0; k < 3; ++k) {
    voxels.count[k] = static_cast<int>((highest[k] - lowest[k]) / voxels.step_m) + 1 + 2 * padding;
  }
  voxels.origin = lowest - Vec3::Constant(voxels.padding_m);
  std::vector<std::uint8_t> on_surface(voxels.count.prod(), 0);
  for (const Triangle& t : surface) mark(t, voxels, on_surface);
  flood_fill_outside(voxels, on_surface);
  std::vector<std::uint8_t> outer(on_surface.size(), 0);
  for_each_neighbour(voxels, [&](std::ptrdiff_t cell, std::ptrdiff_t next) {
    if (on_surface[cell] && !voxels.inside[next]) outer[cell] = 1;
  });
  voxels.distance = distances_to(voxels, outer);
  return voxels;
}

std::vector<std::uint8_t> voxels_nearer_to(const std::vector<Triangle>& other, double clearance_m,
                                           const Voxels& voxels) {
  std::vector<std::uint8_t> marked(voxels.inside.size(), 0);
  for (const Triangle& t : other) mark(t, voxels, marked);
  const std::vector<float> to_other = distances_to(voxels, marked);
  for (std::ptrdiff_t cell = 0; cell < std::ssize(marked); ++cell)
    marked[cell] = !voxels.inside[cell] && to_other[cell] < voxels.distance[cell] + clearance_m;
  return marked;
}

}  // namespace morphe::cover
