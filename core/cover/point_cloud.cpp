#include "core/cover/point_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

#include "core/cover/constants.hpp"

namespace morphe::cover {
namespace {

constexpr std::ptrdiff_t kSimdWidth = 8, kBlockSize = 32;
using Floats = float __attribute__((vector_size(kSimdWidth * sizeof(float))));
using Ints = int __attribute__((vector_size(kSimdWidth * sizeof(int))));

/// The segment and the radius of a capsule.
struct Filter {
  Eigen::Vector3f from, axis;
  float inverse_square, square_radius;

  explicit Filter(const collision::CapsuleBody& capsule)
      : from(capsule.from.cast<float>()), axis((capsule.to - capsule.from).cast<float>()) {
    const float square = axis.squaredNorm();
    inverse_square = square > 0 ? 1 / square : 0;
    square_radius = static_cast<float>(capsule.radius * capsule.radius);
  }
  float square_distance(float x, float y, float z) const {
    x -= from.x();
    y -= from.y();
    z -= from.z();
    const float t =
        std::clamp((x * axis.x() + y * axis.y() + z * axis.z()) * inverse_square, 0.0F, 1.0F);
    x -= t * axis.x();
    y -= t * axis.y();
    z -= t * axis.z();
    return x * x + y * y + z * z;
  }
  bool contains(float x, float y, float z) const {
    return square_distance(x, y, z) <= square_radius;
  }
};

/// Returns the number of points of a block in a capsule, by the arithmetic of Filter.
int count_in_block(const Filter& filter, const float* xs, const float* ys, const float* zs) {
  const Floats zero{}, one = zero + 1.0F;
  Ints count{};
  for (std::ptrdiff_t p = 0; p < kBlockSize; p += kSimdWidth) {
    Floats x, y, z;
    std::memcpy(&x, xs + p, sizeof x);
    std::memcpy(&y, ys + p, sizeof y);
    std::memcpy(&z, zs + p, sizeof z);
    x -= filter.from.x();
    y -= filter.from.y();
    z -= filter.from.z();
    Floats t =
        (x * filter.axis.x() + y * filter.axis.y() + z * filter.axis.z()) * filter.inverse_square;
    t = t < zero ? zero : t;
    t = t > one ? one : t;
    x -= t * filter.axis.x();
    y -= t * filter.axis.y();
    z -= t * filter.axis.z();
    count -= (x * x + y * y + z * z) <= zero + filter.square_radius;
  }
  int sum = 0;
  for (std::ptrdiff_t k = 0; k < kSimdWidth; ++k) sum += count[k];
  return sum;
}

}  // namespace

PointCloud::PointCloud(const std::vector<Vec3>& points) {
  points_.reserve(points.size());
  for (const Vec3& point : points) points_.push_back(point.cast<float>());
  arrange();
}

/// Halves the points along the longest side of their box until a block holds the rest.
void PointCloud::arrange() {
  std::vector<Eigen::Vector3f> sorted = points_;
  const auto halve = [](const auto& self, std::span<Eigen::Vector3f> part) -> void {
    const auto blocks = (std::ssize(part) + kBlockSize - 1) / kBlockSize;
    if (blocks < 2) return;
    Eigen::Vector3f lowest = part.front(), highest = lowest;
    for (const Eigen::Vector3f& point : part) {
      lowest = lowest.cwiseMin(point);
      highest = highest.cwiseMax(point);
    }
    int axis = 0;
    (highest - lowest).maxCoeff(&axis);
    const auto middle = blocks / 2 * kBlockSize;
    std::ranges::nth_element(part, part.begin() + middle, {},
                             [axis](const Eigen::Vector3f& point) { return point[axis]; });
    self(self, part.first(static_cast<std::size_t>(middle)));
    self(self, part.subspan(static_cast<std::size_t>(middle)));
  };
  halve(halve, sorted);
  const auto blocks = (size() + kBlockSize - 1) / kBlockSize;
  constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
  for (std::vector<float>* values : {&x_, &y_, &z_})
    values->assign(static_cast<std::size_t>(blocks * kBlockSize), kNowhere);
  blocks_.clear();
  for (std::ptrdiff_t begin = 0; begin < size(); begin += kBlockSize) {
    const auto end = std::min(begin + kBlockSize, size());
    Block& block = blocks_.emplace_back();
    Eigen::Vector3f lowest = sorted[begin], highest = lowest;
    for (auto p = begin; p < end; ++p) {
      x_[p] = sorted[p].x();
      y_[p] = sorted[p].y();
      z_[p] = sorted[p].z();
      lowest = lowest.cwiseMin(sorted[p]);
      highest = highest.cwiseMax(sorted[p]);
    }
    block.centre = 0.5F * (lowest + highest);
    for (auto p = begin; p < end; ++p)
      block.radius = std::max(block.radius, (sorted[p] - block.centre).norm());
    block.radius += kRoundOff_m;
  }
}

int PointCloud::count_inside(const collision::CapsuleBody& capsule) const {
  if (!(capsule.radius > 0)) return 0;
  const Filter filter(capsule);
  const auto radius = static_cast<float>(capsule.radius);
  std::ptrdiff_t count = 0;
  for (std::ptrdiff_t b = 0; b < std::ssize(blocks_); ++b) {
    const Block& block = blocks_[b];
    const float square =
        filter.square_distance(block.centre.x(), block.centre.y(), block.centre.z());
    const float outer = radius + block.radius, inner = radius - block.radius;
    if (square > outer * outer) continue;
    const std::ptrdiff_t begin = b * kBlockSize;
    if (inner > 0 && square < inner * inner)
      count += std::min(kBlockSize, size() - begin);
    else
      count += count_in_block(filter, x_.data() + begin, y_.data() + begin, z_.data() + begin);
  }
  return static_cast<int>(count);
}

void PointCloud::remove_inside(const collision::CapsuleBody& capsule) {
  const Filter filter(capsule);
  std::erase_if(points_, [&](const Eigen::Vector3f& point) {
    return filter.contains(point.x(), point.y(), point.z());
  });
  arrange();
}

}  // namespace morphe::cover
