#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "core/files/sha256.hpp"
#include "core/math/seed.hpp"
#include "core/parallel/for_each.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "pipeline/study/grasp_rows.hpp"
#include "pipeline/study/held_objects.hpp"
#include "pipeline/study/results.hpp"
#include "pipeline/study/study.hpp"
#include "stages/import/import.hpp"

namespace morphe::study {
namespace {

constexpr Shape kShapes[] = {Shape::sphere, Shape::cylinder, Shape::box};

struct RecordedGrasp {
  Demonstration demonstration;
  std::vector<KnownContact> contacts;  ///< contacts of its synthetic object, if it has one
};

struct PlannedRecording {
  std::string name;
  std::vector<GraspComparison> pairs;
  std::vector<Plan> contacts, fingertips;
};

/// Adds synthetic recordings; with known objects, only those in whose hand an object fits.
void add_synthetic_grasps(const GraspSet& set, const std::filesystem::path& folder, int count,
                          double pad_depth_m, std::vector<RecordedGrasp>& all) {
  constexpr int kMaxRecordingsPerGrasp = 10;  // tried for each that is required
  synthesize::SynthesizeOptions options;
  const config::ConfigNode node = config::ConfigNode::load(folder / set.synthetic);
  config::read_document(node, options);
  for (int index = 0, made = 0; made < count && index < kMaxRecordingsPerGrasp * count; ++index) {
    synthesize::SyntheticRecording synthetic = synthesize::synthesize(options, set.seed, index);
    if (!set.known_objects) {
      all.push_back({std::move(synthetic.recorded), {}});
      ++made;
      continue;
    }
    math::RandomStream random(math::seed_from(set.seed, "held object", index), set.name);
    std::optional<KnownGrasp> known =
        add_held_object(synthetic, kShapes[made % std::ssize(kShapes)], pad_depth_m, random);
    if (!known) continue;
    all.push_back({std::move(known->recorded), std::move(known->contacts)});
    ++made;
  }
}

std::vector<RecordedGrasp> load_recordings(const GraspSet& set, const StudyRun& run,
                                           double pad_depth_m) {
  const std::filesystem::path folder = run.config.parent_path();
  std::vector<RecordedGrasp> all;
  if (!set.manifest.empty()) {
    imports::ImportRequest request;
    request.paths = {folder / set.manifest};
    imports::import_recordings(request, [&](Demonstration&& demonstration) {
      if (run.quick && std::ssize(all) >= set.quick_count) return;
      all.push_back({std::move(demonstration), {}});
    });
  }
  if (!set.synthetic.empty())
    add_synthetic_grasps(set, folder, run.quick ? set.quick_count : set.count, pad_depth_m, all);
  return all;
}

/// Returns the contacts of a movement with its synthetic or recorded object; empty if the object
/// was inferred.
std::vector<KnownContact> known_contacts_of(const RecordedGrasp& recording,
                                            const planning::Reconstruction& reconstruction,
                                            const Movement& movement,
                                            const grasp::GraspOptions& options) {
  const SceneObject* target = find_object(reconstruction.on_robot_side.objects, movement.target);
  if (!target) return {};
  if (!recording.contacts.empty())
    return target->name == kHeldObjectName ? recording.contacts : std::vector<KnownContact>{};
  const double grasp_s = grasp_instant_s(movement.phases);
  const HumanMotion& motion = reconstruction.motion;
  const std::ptrdiff_t frame = std::ranges::lower_bound(motion.time, grasp_s) - motion.time.begin();
  if (!(grasp_s >= movement.begin_s) || frame >= std::ssize(motion.time)) return {};
  ObservedHand hand;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    hand.tip[finger] = motion.tip(frame, finger);
    hand.middle_joint[finger] = motion.finger_joint(frame, finger);
  }
  return recorded_contacts(*target, motion.time[frame], hand, options);
}

/// The configs of a hand of a set in both variants.
struct HandVariants {
  planning::LoadedConfig contacts, fingertips;
  const grasp::GraspOptions& options() const { return *contacts.options.grasp; }
};

HandVariants load_hand(const GraspStudyOptions& options, const std::filesystem::path& pipeline) {
  HandVariants hand{planning::load_config(pipeline, options.contacts.set),
                    planning::load_config(pipeline, options.fingertips.set)};
  if (!hand.contacts.options.grasp || hand.fingertips.options.grasp) {
    throw InputError(fmt::format("{}: `{}` must set a key of grasp, and `{}` must not",
                                 pipeline.string(), options.contacts.name,
                                 options.fingertips.name));
  }
  return hand;
}

PlannedRecording plan_both_variants(const HandVariants& hand, const RecordedGrasp& recording) {
  const robot::Robot& robot = hand.contacts.robot;
  const planning::PlanningInputs with_contacts{hand.contacts.options, robot},
      with_fingertips{hand.fingertips.options, robot};
  PlannedRecording planned{recording.demonstration.name, {}, {}, {}};
  planned.contacts = planning::plan_demonstration(with_contacts, recording.demonstration).plans;
  planned.fingertips = planning::plan_demonstration(with_fingertips, recording.demonstration).plans;
  const planning::Reconstruction reconstruction =
      planning::reconstruct_demonstration(with_fingertips, recording.demonstration);
  if (planned.contacts.size() != planned.fingertips.size())
    throw InputError(planned.name + ": the variants do not find the same movements");
  for (int k = 0; k < std::ssize(planned.contacts); ++k) {
    const Plan &contacts = planned.contacts[k], &fingertips = planned.fingertips[k];
    const std::vector<KnownContact> known =
        known_contacts_of(recording, reconstruction, contacts.movement, hand.options());
    GraspComparison& pair = planned.pairs.emplace_back();
    pair.contacts = score_grasp(robot, contacts, known);
    pair.fingertips = score_grasp(robot, fingertips, known);
    if (contacts.has_trajectory())
      pair.demonstrated_contacts = count_demonstrated_contacts(robot, fingertips, hand.options());
  }
  return planned;
}

/// Opens the file of the plans of one variant beside the results, null if there is no folder.
std::unique_ptr<store::PlanWriter> writer_of(const StudyRun& run, const GraspSet& set,
                                             const StudyVariant& variant,
                                             const planning::LoadedConfig& config) {
  if (run.folder.empty()) return nullptr;
  const std::filesystem::path plans = run.folder / "plans";
  std::filesystem::create_directories(plans);
  const std::string name = fmt::format("{}-{}-{}", set.name, config.robot.name, variant.name);
  const std::string dataset =
      fmt::format("{}/{}/{}", set.name, set.seed, set.synthetic + set.manifest);
  return std::make_unique<store::PlanWriter>(
      plans / (name + ".h5"), planning::header_of(config, files::sha256(dataset)), config.robot);
}

std::vector<GraspComparison> plan_set(const GraspStudyOptions& options, const GraspSet& set,
                                      const HandVariants& hand,
                                      const std::vector<RecordedGrasp>& recordings,
                                      const StudyRun& run) {
  const auto contacts = writer_of(run, set, options.contacts, hand.contacts);
  const auto fingertips = writer_of(run, set, options.fingertips, hand.fingertips);
  std::vector<GraspComparison> pairs;
  parallel::ordered_for_each<PlannedRecording>(
      static_cast<int>(recordings.size()), run.jobs,
      [&](std::uint64_t index) { return plan_both_variants(hand, recordings[index]); },
      [&](const PlannedRecording& planned) {
        for (int k = 0; k < std::ssize(planned.pairs); ++k) {
          const GraspComparison& pair = planned.pairs[k];
          if (contacts) contacts->add(planned.contacts[k]);
          if (fingertips) fingertips->add(planned.fingertips[k]);
          pairs.push_back(pair);
          run.progress(fmt::format("{}, {}, {}/{}: {} {}, {} of {} touch; {} {}", set.name,
                                   hand.contacts.robot.name, planned.name, k, options.contacts.name,
                                   name_of(planned.contacts[k].status()), pair.contacts.touching,
                                   pair.demonstrated_contacts, options.fingertips.name,
                                   name_of(planned.fingertips[k].status())));
        }
      });
  if (contacts) contacts->finish();
  if (fingertips) fingertips->finish();
  return pairs;
}

}  // namespace

std::string validation_error(const GraspSet& set) {
  if (set.pipelines.empty()) return "pipelines is empty";
  if (set.manifest.empty() && set.synthetic.empty()) return "needs `manifest` or `synthetic`";
  if (set.known_objects && set.synthetic.empty()) return "known_objects needs `synthetic`";
  return "";
}

std::string validation_error(const GraspStudyOptions& options) {
  if (options.sets.empty()) return "sets is empty";
  if (options.contacts.name == options.fingertips.name)
    return "contacts and fingertips have the same name";
  for (const GraspSet& set : options.sets) {
    if (std::ranges::count(options.sets, set.name, &GraspSet::name) > 1)
      return fmt::format("two sets have the name '{}'", set.name);
  }
  return "";
}

StudyResult grasp_study(const config::ConfigNode& config, const StudyRun& run) {
  GraspStudyOptions options;
  config::read_document(config, options);
  const std::filesystem::path folder = run.config.parent_path();
  StudyResult result;
  for (GraspSet& set : options.sets) {
    if (run.quick && std::ssize(set.pipelines) > options.quick_hands)
      set.pipelines.resize(options.quick_hands);
    std::vector<RecordedGrasp> recordings;
    for (const std::string& pipeline : set.pipelines) {
      const HandVariants hand = load_hand(options, folder / pipeline);
      if (recordings.empty()) recordings = load_recordings(set, run, hand.options().pad_depth_m);
      const std::vector<GraspComparison> pairs = plan_set(options, set, hand, recordings, run);
      StudyResult hand_result;  // reports intermediate results, because the study takes hours
      add_grasp_rows(options, {{"set", set.name}, {"hand", hand.contacts.robot.name}}, pairs,
                     hand_result);
      run.progress(results_table(hand_result));
      std::ranges::move(hand_result.rows, std::back_inserter(result.rows));
    }
  }
  return result;
}

}  // namespace morphe::study
