// Epsilon of Ferrari and Canny, the margin against gravity and shared forces, on random grasps of
// ellipsoids.
//   bench_closure [--quick]
//   bench_closure --brackets N [--edges M]   N grasps between hulls of inscribed and circumscribed
//                                            M-gons, by qhull
//   bench_closure --closed-forms GAP         the closed forms at this gap of the bounds
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "core/closure/ferrari_canny.hpp"
#include "core/closure/grasp_forces.hpp"
#include "core/closure/gravity_margin.hpp"
#include "tests/core/closure/grasps.hpp"
#include "tests/core/closure/polygon_hull.hpp"

namespace morphe::closure {
namespace {

using Clock = std::chrono::steady_clock;

/// The least of some tries: what else runs on the machine is not its business.
template <class Call>
double milliseconds(Call call, int tries = 3) {
  double least = kInfinity;
  for (int k = 0; k < tries; ++k) {
    const auto begin = Clock::now();
    call();
    least =
        std::min(least, std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  return least;
}

/// One row: what came out of many grasps.
struct Tally {
  std::vector<double> ms;
  int positive = 0, within = 0, most_facets = 0;
  double insertions = 0, widest = 0;

  /// `gap`: upper - lower over what is allowed at these bounds.
  void add(double took, double lower, double gap, bool ok, int inserted, int facets) {
    ms.push_back(took);
    positive += lower > 0;
    within += ok;
    insertions += inserted;
    widest = std::max(widest, gap);
    most_facets = std::max(most_facets, facets);
  }
  double at(double share) {
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(ms.size() - 1));
    std::nth_element(ms.begin(), ms.begin() + k, ms.end());
    return ms[static_cast<std::size_t>(k)];
  }
  void print(const std::string& name) {
    double sum = 0;
    for (const double one : ms) sum += one;
    const auto n = static_cast<double>(ms.size());
    fmt::print("{:34} {:6} {:8} {:7} {:9.2e} {:6.1f} {:7} {:8.3f} {:8.3f} {:9.0f}\n", name,
               ms.size(), positive, within, widest, insertions / n, most_facets, at(0.5), at(0.99),
               1000 * n / sum);
  }
};

void header(const std::string& name) {
  fmt::print("\n{:34} {:>6} {:>8} {:>7} {:>9} {:>6} {:>7} {:>8} {:>8} {:>9}\n", name, "grasps",
             "above 0", "within", "gap/tol", "points", "facets", "median", "p99 ms", "a second");
}

/// Share of the tolerance that the bounds take.
double gap_share(double lower, double upper, const BoundTolerance& tolerance) {
  const double least = lower > 0 || upper < 0 ? std::min(std::abs(lower), std::abs(upper)) : 0;
  return (upper - lower) / std::max(tolerance.absolute, tolerance.relative * least);
}

template <class Make>
void epsilon_row(const std::string& name, ForceLimit limit, int count, Make make) {
  math::RandomStream random(1, name);
  Tally tally;
  for (int k = 0; k < count; ++k) {
    const ContactSet set = make(random, k);
    FerrariCanny found;
    const double took = milliseconds([&] { found = ferrari_canny(set, limit); });
    tally.add(took, found.lower, gap_share(found.lower, found.upper, {}), found.within_tolerance,
              found.insertions, found.facets);
  }
  tally.print(name);
}

void epsilon(int count) {
  for (const ForceLimit limit : {ForceLimit::sum, ForceLimit::each}) {
    header(limit == ForceLimit::sum ? "epsilon, L1" : "epsilon, L-infinity");
    const int some = limit == ForceLimit::sum ? count : count / 5;
    for (const double gamma : {0.0, 0.002, 0.02}) {
      for (int n = gamma > 0 ? 2 : 3; n <= 5; ++n) {
        epsilon_row(
            fmt::format("{} contacts, gamma {} mm", n, 1000 * gamma), limit, some,
            [&](math::RandomStream& random, int) { return random_grasp(random, n, gamma); });
      }
    }
    for (const double off : {0.0, 1e-9}) {
      epsilon_row(off > 0 ? "1e-9 from flat" : "flat", limit, some,
                  [&](math::RandomStream& random, int k) { return flat_grasp(random, k, off); });
    }
  }
}

void gravity(int count) {
  header("gravity margin");
  for (const bool worst : {false, true}) {
    for (int n = 2; n <= 5; ++n) {
      math::RandomStream random(1, "gravity");
      Tally tally;
      for (int k = 0; k < count; ++k) {
        const ContactSet set = random_grasp(random, n, 0.002);
        const Load load{0.3, 0.005 * random.normal_vector3()};
        GravityMargin found;
        const double took = milliseconds([&] {
          found =
              worst ? worst_gravity_margin(set, load) : gravity_margin(set, load, -Vec3::UnitZ());
        });
        tally.add(took, found.lower, gap_share(found.lower, found.upper, {0.01, 1e-3}),
                  found.within_tolerance, found.insertions, found.facets);
      }
      tally.print(fmt::format("{} contacts, {}", n, worst ? "worst direction" : "downwards"));
    }
  }
}

/// "above 0": balanced to 1e-6 N.
void sharing(int count) {
  header("shared forces, 0.1 kg");
  for (int n = 2; n <= 5; ++n) {
    math::RandomStream random(1, "sharing");
    Tally tally;
    for (int k = 0; k < count; ++k) {
      const ContactSet set = random_grasp(random, n, 0.002);
      GraspForces found;
      const double took = milliseconds([&] {
        found = distribute_grasp_forces(set, -0.981 * Wrench::Unit(2), {8, 0.1, 0.8});
      });
      tally.add(took, found.residual.norm() < 1e-6 ? 1 : 0, 0, found.converged, 0, 0);
    }
    tally.print(fmt::format("{} contacts", n));
  }
}

int brackets(int count, int edges) {
  math::RandomStream random(1, "polygons");
  int closed = 0, outside = 0, inside_gap = 0;
  double ours = 0, hulls = 0, widest = 0;
  for (int k = 0; k < count; ++k) {
    const ContactSet set = random_grasp(random, 3 + k % 3, 0);
    FerrariCanny found;
    ours += milliseconds([&] { found = ferrari_canny(set, ForceLimit::sum); });
    double inscribed = 0, around = 0;
    hulls += milliseconds(
        [&] {
          inscribed = polygon_epsilon(set, edges, false);
          around = polygon_epsilon(set, edges, true);
        },
        1);
    closed += found.force_closure();
    const bool below = found.force_closure() && around < found.lower - 1e-9;
    const bool above = inscribed > 0 && inscribed > found.upper + 1e-9;
    outside += below || above;
    inside_gap += found.force_closure() && found.lower >= inscribed && found.upper <= around;
    if (inscribed > 0) widest = std::max(widest, around - inscribed);
  }
  fmt::print(
      "{} grasps, {}-gons: closed {}, bounds beside the hulls {}, wholly between them {}\n"
      "widest of the hulls {:.4f}; ms a grasp: ours {:.3f}, both hulls {:.1f}\n",
      count, edges, closed, outside, inside_gap, widest, ours / count, hulls / count);
  return outside > 0;
}

int forms(double gap) {
  fmt::print("{:20} {:>4} {:>10} {:>10} {:>10} {:>9} {:>9} {:>9}\n", "case", "", "closed form",
             "low", "high", "points", "facets", "ms");
  int wrong = 0;
  for (const ClosedForm& form : closed_forms()) {
    for (const ForceLimit limit : {ForceLimit::sum, ForceLimit::each}) {
      const double truth = limit == ForceLimit::sum ? form.sum : form.each;
      if (std::isnan(truth)) continue;
      // Of L∞ the facets are too many for more.
      const double wanted = limit == ForceLimit::sum ? gap : std::max(gap, 1e-3);
      FerrariCanny found;
      const double took = milliseconds([&] {
        found = ferrari_canny(form.set, limit, {0, wanted, 2000});
      });
      // Numbers of the table have six digits.
      wrong +=
          !(found.lower <= truth + 1e-6 && truth <= found.upper + 1e-6 && found.within_tolerance);
      fmt::print("{:20} {:>4} {:10.6f} {:10.6f} {:10.6f} {:9} {:9} {:9.1f}\n", form.name,
                 limit == ForceLimit::sum ? "L1" : "Linf", truth, found.lower, found.upper,
                 found.insertions, found.facets, took);
    }
  }
  return wrong > 0;
}

}  // namespace
}  // namespace morphe::closure

int main(int argc, char** argv) {
  CLI::App app{"Epsilon of Ferrari and Canny, margin against gravity, shared forces"};
  bool quick = false;
  int brackets = 0, edges = 16;
  double gap = 0;
  app.add_flag("--quick", quick);
  app.add_option("--brackets", brackets, "this many grasps between hulls of polygons instead");
  app.add_option("--edges", edges, "of the polygons")->capture_default_str();
  app.add_option("--closed-forms", gap, "the closed forms at this gap instead");
  CLI11_PARSE(app, argc, argv);
  if (brackets > 0) return morphe::closure::brackets(brackets, edges);
  if (gap > 0) return morphe::closure::forms(gap);
  const int count = quick ? 200 : 1000;
  morphe::closure::epsilon(count);
  morphe::closure::gravity(count / 5);
  morphe::closure::sharing(count);
  return 0;
}
