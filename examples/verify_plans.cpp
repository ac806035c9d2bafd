// Judges a plans.h5 from the file alone, before a robot gets to see it: limits and clearance along
// the curve between samples, fingertips at their goals, and whether the certificate says the truth.
//
//   verify_plans PLANS.h5        exit 1 if something does not hold
#include <cstdio>
#include <morphe/morphe.hpp>

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: verify_plans PLANS.h5\n");
    return 2;
  }
  const morphe::verify::VerifyReport report = morphe::verify_plans(argv[1]);
  for (const morphe::verify::Violation& wrong : report.violations) {
    std::printf("%s at %.3f s: %s %s: %g, allowed %g\n", wrong.plan.c_str(), wrong.time_s,
                wrong.cause.c_str(), wrong.subject.c_str(), wrong.value, wrong.limit);
  }
  std::printf("%d executable, %d infeasible, %zu violations\n", report.executable,
              report.infeasible, report.violations.size());
  return report.violations.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
