#pragma once

#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::verify {

/// A facet of a convex hull: normal·x <= distance for all points x of the hull.
struct HullFacet {
  Eigen::VectorXd normal;  ///< unit, outwards
  double distance = 0;     ///< of the facet from the origin, along the normal
};

/// Computes with qhull the facets of the convex hull of points, which are the columns of a matrix
/// with two or more rows. Returns an empty vector if there is no hull, because there are too few
/// points or they lie in a hyperplane.
std::vector<HullFacet> hull_facets(Eigen::MatrixXd points);

}  // namespace morphe::verify
