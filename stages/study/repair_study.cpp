#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "pipeline/collision/certified.hpp"
#include "pipeline/collision/fcl_engine.hpp"
#include "pipeline/math/seed.hpp"
#include "pipeline/math/statistics.hpp"
#include "pipeline/parallel/for_each.hpp"
#include "stages/certify/goal_errors.hpp"
#include "stages/planning/plan_movement.hpp"
#include "stages/repair/detour.hpp"
#include "stages/study/obstacles.hpp"
#include "stages/study/repair_options.hpp"
#include "stages/study/study.hpp"
#include "stages/synthesize/synthesize.hpp"

namespace morphe::study {
namespace {

/// One movement of a recording, before anything is planned.
struct Recorded {
  Demonstration demonstration;
  HumanMotion motion;
  Movement movement;
};

/// What one way of repairing made of a case.
struct Repaired {
  bool executable = false;
  double a_ratio = kNotSeen;     ///< metric A of the path over that of the mapping
  double tips_m = kNotSeen;      ///< mean over the path
  bool outside_changed = false;  ///< a sample that is called mapped is not what was mapped
  std::size_t collisions = 0;    ///< states of the trajectory that FCL finds in collision
  std::size_t states = 0;
  std::string failure;  ///< reason and detail
};

struct ObstacleCase {
  bool exists = false;  ///< executable without an obstacle, and one can be put into the way
  std::uint64_t recording = 0;
  std::string kind;
  std::vector<Repaired> variants;
  bool found_by_long_search = false;
};

struct Study {
  const RepairStudyOptions& options;
  std::filesystem::path pipeline;
  synthesize::SynthesizeOptions synthetic;
};

Recorded recorded_movement(const Study& study, const planning::PipelineConfig& config,
                           std::uint64_t index) {
  Recorded recorded{
      synthesize::synthesize(study.synthetic, study.options.seed, index).recorded, {}, {}};
  recorded.motion =
      reconstruct::reconstruct(recorded.demonstration, config.reconstruct, config.human);
  const std::vector<Movement> movements =
      segment::segment(recorded.motion, config.segment, recorded.demonstration.objects);
  if (!movements.empty()) recorded.movement = movements.front();
  return recorded;
}

Plan plan_with(const planning::LoadedConfig& loaded,
               const std::optional<scene::ConfiguredObject>& obstacle, const Recorded& recorded) {
  planning::PipelineConfig config = loaded.options;
  if (obstacle) config.scene.objects.push_back(*obstacle);
  const planning::Planner planner{config, loaded.robot};
  planning::StageSeconds seconds;
  return planning::plan_movement(planner, recorded.demonstration, recorded.motion,
                                 recorded.movement, seconds);
}

/// FCL alone, no margin, at states between which no body moves farther than `step_m`.
void look_for_collisions(const robot::Robot& robot, const Plan& plan, const Trajectory& trajectory,
                         double step_m, Repaired& repaired) {
  Tolerances touching = plan.tolerances;
  touching.margin = 0;
  const collision::CollisionWorld world =
      collision::make_world(robot, plan.scene, plan.movement, touching);
  collision::FclEngine engine(world);
  collision::CollisionScratch scratch;
  for (std::size_t i = 1; i < trajectory.samples(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const JointVector from = trajectory.position.row(row - 1), to = trajectory.position.row(row);
    const double travel_m = (robot.capsule_levers * (to - from).cwiseAbs()).maxCoeff();
    const int steps = std::max(1, static_cast<int>(std::ceil(travel_m / step_m)));
    for (int k = 0; k < steps; ++k) {
      const double share = static_cast<double>(k) / steps;
      const double from_s = trajectory.demonstration_time[i - 1];
      const double time_s = from_s + share * (trajectory.demonstration_time[i] - from_s);
      repaired.collisions += engine.free(from + share * (to - from), time_s, scratch) ? 0 : 1;
      ++repaired.states;
    }
  }
}

Repaired check(const Study& study, const robot::Robot& robot, const Plan& plan) {
  Repaired repaired;
  repaired.executable = plan.executable();
  repaired.failure =
      plan.executable() ? "" : fmt::format("{} ({})", name_of(plan.reason), plan.detail);
  if (!repaired.executable) return repaired;
  Trajectory untimed;
  untimed.time = untimed.demonstration_time = plan.path.demonstration_time;
  untimed.position = plan.path.position;
  const certify::GoalErrors errors =
      certify::goal_errors(robot, plan.goals, plan.movement, plan.tolerances, untimed);
  repaired.a_ratio = errors.humanlikeness / plan.certificate.humanlikeness_mapped;
  repaired.tips_m = errors.position_mean;
  for (std::size_t k = 0; k < plan.path.origin.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    repaired.outside_changed |= plan.path.origin[k] == Origin::mapped &&
                                plan.path.position.row(row) != plan.mapped.position.row(row);
  }
  look_for_collisions(robot, plan, plan.trajectory.samples() > 0 ? plan.trajectory : untimed,
                      study.options.step_m, repaired);
  return repaired;
}

/// What a planner alone makes of the path that was free before the obstacle came.
Plan repair_plainly(const planning::LoadedConfig& loaded, const Plan& undisturbed,
                    const Plan& disturbed, std::uint64_t seed) {
  Plan plan = undisturbed;
  plan.scene = disturbed.scene;
  plan.trajectory = {};
  const collision::CollisionWorld world =
      collision::make_world(loaded.robot, plan.scene, plan.movement, plan.tolerances);
  const repair::Check check = [&](const JointPath& path) {
    return check::check_path(world, plan.goals, plan.movement, path, loaded.options.check);
  };
  const repair::Surroundings around{world, loaded.options.repair, seed, check, {}};
  const repair::Checked start{plan.path, check(plan.path)};
  const repair::Rung a_detour = [&](const repair::Checked& best) {
    return repair::detour(around, best);
  };
  const Outcome<repair::RepairResult> repaired =
      repair::repair_path({a_detour}, start, loaded.options.repair);
  plan.path = repaired.value.path;
  plan.reason = repaired.refusal.reason;
  plan.detail = repaired.refusal.detail;
  return plan;
}

ObstacleCase run_case(const Study& study, const std::vector<planning::LoadedConfig>& variants,
                      const planning::LoadedConfig& plain,
                      const std::vector<planning::LoadedConfig>& long_searches,
                      std::uint64_t index) {
  ObstacleCase result;
  result.recording = index;
  result.kind = kObstacleKinds[index % std::size(kObstacleKinds)];
  const planning::LoadedConfig& ours = variants.front();
  const Recorded recorded = recorded_movement(study, ours.options, index);
  if (recorded.movement.phases.empty()) return result;
  const Plan undisturbed = plan_with(ours, std::nullopt, recorded);
  if (!undisturbed.executable()) return result;
  const std::uint64_t seed =
      math::seed_from(study.options.seed, fmt::format("{}/{}", index, result.kind));
  const Pose world_from_base =
      map::place_robot(ours.robot, map::shoulder_at_begin(recorded.motion, recorded.movement),
                       ours.options.placement);
  const std::optional<scene::ConfiguredObject> obstacle =
      obstacle_in_the_way(ours.robot, undisturbed, world_from_base, result.kind, seed);
  if (!obstacle) return result;
  result.exists = true;
  Plan disturbed;
  for (const planning::LoadedConfig& variant : variants) {
    disturbed = plan_with(variant, obstacle, recorded);
    result.variants.push_back(check(study, ours.robot, disturbed));
  }
  result.variants.push_back(
      check(study, ours.robot, repair_plainly(plain, undisturbed, disturbed, seed)));
  if (result.variants.front().executable) return result;
  for (const planning::LoadedConfig& search : long_searches) {
    if (result.found_by_long_search) break;
    result.found_by_long_search = plan_with(search, obstacle, recorded).executable();
  }
  return result;
}

void add_rows(const RepairStudyOptions& options, const std::string& kind,
              const std::vector<ObstacleCase>& cases, StudyResult& result) {
  std::vector<const ObstacleCase*> of_kind;
  for (const ObstacleCase& one : cases) {
    if (kind == "all" || one.kind == kind) of_kind.push_back(&one);
  }
  if (of_kind.empty()) return;
  double ours_a = kNotSeen;
  std::vector<StudyVariant> variants = options.variants;
  variants.push_back(options.plain);
  for (std::size_t v = 0; v < variants.size(); ++v) {
    std::size_t solved = 0, solvable = 0, collisions = 0, changed = 0;
    std::vector<double> a_ratio, tips, both_a, both_tips;
    for (const ObstacleCase* one : of_kind) {
      const Repaired& repaired = one->variants[v];
      solved += repaired.executable ? 1 : 0;
      solvable +=
          one->variants.front().executable || one->found_by_long_search || repaired.executable ? 1
                                                                                               : 0;
      collisions += repaired.collisions;
      changed += repaired.outside_changed ? 1 : 0;
      if (!repaired.executable) continue;
      a_ratio.push_back(repaired.a_ratio);
      tips.push_back(repaired.tips_m);
      if (!std::ranges::all_of(one->variants, &Repaired::executable)) continue;
      both_a.push_back(repaired.a_ratio);
      both_tips.push_back(repaired.tips_m);
    }
    const bool first = v == 0, whole = kind == "all";
    const Case of = {{"obstacle", kind}, {"variant", variants[v].name}};
    const auto row = [&](const char* metric, const char* unit, double value,
                         std::size_t n) -> StudyRow& {
      result.rows.push_back(row_of(of, metric, unit, value, n));
      return result.rows.back();
    };
    row("executable", "1", static_cast<double>(solved) / static_cast<double>(of_kind.size()),
        of_kind.size());
    StudyRow& share = row("executable of the solvable", "1",
                          static_cast<double>(solved) / static_cast<double>(solvable), solvable);
    if (first && whole) share.at_least = 0.98;
    StudyRow& hits = row("states in collision", "1", static_cast<double>(collisions), solved);
    if (first) hits.at_most = 0;
    StudyRow& bits =
        row("changed outside the repaired intervals", "1", static_cast<double>(changed), solved);
    if (first) bits.at_most = 0;
    StudyRow& a =
        row("A over the mapping's, median", "1", math::quantile(a_ratio, 0.5), a_ratio.size());
    if (first && whole) a.at_most = 1.25;
    row("fingertips from their goals, mean", "m", math::mean(tips), tips.size());
    StudyRow& common = row("A over the mapping's, where all succeed, mean", "1", math::mean(both_a),
                           both_a.size());
    if (first) {
      ours_a = common.ours;
    } else if (whole) {
      common.at_least = ours_a;  // ours is not worse
    }
    row("fingertips, where all succeed, mean", "m", math::mean(both_tips), both_tips.size());
  }
}

}  // namespace

std::string why_invalid(const RepairStudyOptions& o) {
  if (o.variants.empty()) return "variants is empty";
  if (o.cases < 1 || o.quick_cases < 1) return "cases and quick_cases must be positive";
  if (o.recordings < 1) return "recordings must be positive";
  if (o.first_recording < 0) return "first_recording must not be negative";
  if (!(o.step_m > 0)) return "step_m must be positive";
  return "";
}

StudyResult repair_study(const config::ConfigNode& config, const StudyRun& run) {
  RepairStudyOptions options;
  config::read_options(config, options);
  config.expect_all_read();
  const std::filesystem::path folder = run.config.parent_path();
  Study study{options, folder / options.pipeline, {}};
  const config::ConfigNode node = config::ConfigNode::load(folder / options.synthetic);
  config::read_options(node, study.synthetic);
  node.expect_all_read();

  std::vector<planning::LoadedConfig> variants, long_searches;
  for (const StudyVariant& variant : options.variants) {
    variants.push_back(planning::load_config(study.pipeline, variant.set));
  }
  for (const std::uint64_t seed : options.long_seeds) {
    if (run.quick) break;
    std::vector<std::string> set = options.long_search.set;
    set.push_back(fmt::format("seed={}", seed));
    long_searches.push_back(planning::load_config(study.pipeline, set));
  }

  const planning::LoadedConfig plain = planning::load_config(study.pipeline, options.plain.set);

  const auto wanted = static_cast<std::size_t>(run.quick ? options.quick_cases : options.cases);
  std::vector<ObstacleCase> cases;
  std::size_t looked_at = 0;
  parallel::OrderedMap<std::uint64_t, ObstacleCase> map;
  const int end = options.first_recording + options.recordings;
  map.next = [&, next = options.first_recording]() mutable {
    return cases.size() >= wanted || next == end
               ? nullptr
               : std::make_unique<std::uint64_t>(static_cast<std::uint64_t>(next++));
  };
  map.work = [&](const std::uint64_t& index) {
    return std::make_unique<ObstacleCase>(run_case(study, variants, plain, long_searches, index));
  };
  map.write = [&](const ObstacleCase& one) {
    if (cases.size() >= wanted) return;  // begun before the last one was known to be enough
    ++looked_at;
    if (!one.exists) return;
    cases.push_back(one);
    std::string line = fmt::format("{} of {} cases, recording {}, {}:", cases.size(), wanted,
                                   one.recording, one.kind);
    for (const Repaired& repaired : one.variants) {
      line += repaired.executable ? fmt::format(" A {:.2f}, tips {:.1f} mm;", repaired.a_ratio,
                                                1e3 * repaired.tips_m)
                                  : fmt::format(" {};", repaired.failure);
    }
    if (one.found_by_long_search) line += " found by the long search";
    run.progress(line);
  };
  morphe::parallel::run(map, run.jobs);

  StudyResult result;
  result.rows.push_back(row_of({{"obstacle", "all"}}, "recordings looked at", "1",
                               static_cast<double>(looked_at), cases.size()));
  add_rows(options, "all", cases, result);
  for (const char* kind : kObstacleKinds) add_rows(options, kind, cases, result);
  return result;
}

}  // namespace morphe::study
