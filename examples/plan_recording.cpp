// Recordings and a pipeline -> plans.h5, to the byte what
// `morphe run CONFIG --dataset RECORDINGS` writes.
//
//   plan_recording CONFIG RECORDINGS PLANS.h5 [a.b=value…]
//   plan_recording configs/pipelines/pa10_dlr_hit2.yaml datasets/ue-adl/recordings.yaml plans.h5
#include <cstdio>
#include <morphe/morphe.hpp>

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::fprintf(stderr, "usage: plan_recording CONFIG RECORDINGS PLANS.h5 [a.b=value…]\n");
    return 2;
  }
  const morphe::Pipeline pipeline(argv[1], {argv + 4, argv + argc});

  // Recordings are told apart by content; what they do not say of themselves, a manifest does.
  const std::filesystem::path plans = argv[3];
  const std::filesystem::path imported = plans.parent_path() / "demonstrations.h5";
  morphe::import_recordings(argv[2], imported);

  const morphe::store::DemonstrationReader demonstrations(imported);
  morphe::store::PlanWriter writer(plans, pipeline.header(imported), pipeline.robot());
  for (const std::string& name : demonstrations.names()) {
    for (const morphe::Plan& plan : pipeline.plan(demonstrations.read(name))) {
      std::string said(name_of(plan.status()));  // executable, approximate, partial or infeasible
      if (!plan.has_trajectory()) said = std::string(name_of(plan.reason)) + ": " + plan.detail;
      std::printf("%s/%03d: %s\n", name.c_str(), plan.movement.index, said.c_str());
      writer.add(plan);
    }
  }
  writer.finish();  // plans.h5 is there from here on, and whole
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
