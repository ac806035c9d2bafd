#pragma once

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// Epsilon (L1) of hard contacts with regular `edges`-gons in place of the round cones, by qhull:
/// the least distance of a facet of the hull in six dimensions from 0; below 0 where 0 is outside,
/// NaN where qhull finds no hull. Inscribed in the round cones, or around them.
inline double polygon_epsilon(const ContactSet& set, int edges, bool around) {
  std::vector<double> points;
  const double mu = set.friction.mu / (around ? std::cos(std::numbers::pi / edges) : 1);
  for (const Contact& contact : set.contacts) {
    const Vec3 r = moment_arm(set, contact), across = contact.normal.unitOrthogonal();
    const Vec3 along = contact.normal.cross(across);
    for (int k = 0; k < edges; ++k) {
      const double angle = 2 * std::numbers::pi * k / edges;
      const Wrench wrench =
          wrench_of(contact.normal + mu * (std::cos(angle) * across + std::sin(angle) * along), r);
      points.insert(points.end(), wrench.begin(), wrench.end());
    }
  }
  std::FILE* silence = std::fopen("/dev/null", "w");
  qhT hull;
  qhT* qh = &hull;  // qhull's macros want this name
  qh_zero(qh, silence);
  char command[] = "qhull";
  double least = kUnknown;
  if (!qh_new_qhull(qh, 6, static_cast<int>(points.size() / 6), points.data(), 0, command, silence,
                    silence)) {
    least = kInfinity;
    facetT* facet;
    FORALLfacets { least = std::min(least, -facet->offset); }
  }
  qh_freeqhull(qh, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(qh, &current, &total);
  if (silence) std::fclose(silence);
  return least;
}

}  // namespace morphe::closure
