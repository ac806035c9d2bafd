#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::verify {

/// A facet of a convex hull: normal·x <= distance for all points.
struct HullFacet {
  Eigen::VectorXd normal;  ///< unit, outwards
  double distance = 0;
};

/// Of the columns of `points`, in as many dimensions (two or more) as they have rows, by qhull;
/// none where it finds no hull: too few points, or flat.
std::vector<HullFacet> hull_facets(Eigen::MatrixXd points);

}  // namespace morphe::verify
