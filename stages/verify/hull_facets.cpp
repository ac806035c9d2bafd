#include "stages/verify/hull_facets.hpp"

#include <libqhull_r/qhull_ra.h>

#include <cstdio>

namespace morphe::verify {

std::vector<HullFacet> hull_facets(Eigen::MatrixXd points) {
  std::FILE* silence = std::fopen("/dev/null", "w");
  qhT hull;
  qhT* qh = &hull;  // qhull's macros require this name
  qh_zero(qh, silence);
  char command[] = "qhull";
  std::vector<HullFacet> facets;
  if (!qh_new_qhull(qh, static_cast<int>(points.rows()), static_cast<int>(points.cols()),
                    points.data(), 0, command, silence, silence)) {
    facetT* facet;
    FORALLfacets {
      facets.push_back(
          {Eigen::Map<const Eigen::VectorXd>(facet->normal, points.rows()), -facet->offset});
    }
  }
  qh_freeqhull(qh, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(qh, &current, &total);
  if (silence) std::fclose(silence);
  return facets;
}

}  // namespace morphe::verify
