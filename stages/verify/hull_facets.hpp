#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::verify {

/// A facet of a convex hull: normal·x <= distance for all points.
struct HullFacet {
  Eigen::VectorXd normal;  ///< unit, outwards
  double distance = 0;     ///< from the origin along the normal
};

/// Computes the facets of the convex hull of the columns of `points`, in as many dimensions (two or
/// more) as there are rows, with qhull. Returns an empty vector if there is no hull, because there
/// are too few points or they are coplanar.
std::vector<HullFacet> hull_facets(Eigen::MatrixXd points);

}  // namespace morphe::verify
