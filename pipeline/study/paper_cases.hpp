#pragma once

#include <filesystem>

#include "pipeline/study/mapped_poses.hpp"
#include "pipeline/study/paper_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// The data common to all cases of the paper's study.
struct PaperContext {
  PaperStudyOptions options;
  std::filesystem::path robots;               ///< folder of the robot descriptions
  std::vector<HumanPoses> arms, tips, hands;  ///< for arms, fingertips at a wrist, hands alone
  StudyWeights weights;                       ///< of every case that does not set its own

  /// Returns the length of the human arm from shoulder to wrist [m].
  double arm_length() const { return options.upper_arm + options.forearm; }
  /// Returns the size of the robot hands.
  human::HandSize robot_hand() const {
    return {options.hand_scale * options.hand_length, options.hand_scale * options.hand_breadth};
  }
};

/// Maps all series, one after the other.
MappedPoses map_all(const PaperContext& context, const robot::Robot& robot,
                    const std::vector<HumanPoses>& series, const StudyWeights& weights,
                    const Pose& base_from_shoulder = Pose::Identity());

/// Marks the frames whose goals are met to 0.1 mm and 0.1 degrees by a solve without humanlikeness.
std::vector<char> reachable_frames(const MappedPoses& plain);

/// Returns the values of the frames that are marked by 1.
std::vector<double> marked_values(const std::vector<double>& values,
                                  const std::vector<char>& marked);
/// Computes the mean over the marked frames.
double mean_of_marked(const std::vector<double>& values, const std::vector<char>& marked);

/// The rows of one case, each with the share of the frames whose goals are reachable.
struct ReachableRows {
  const Case& condition;
  std::size_t frames = 0;
  const std::vector<char>& reachable;
  StudyResult& result;

  /// Adds a row and returns it.
  StudyRow& add(const std::string& metric, const std::string& unit, double value) const;
  /// Adds the time of a warm-started solve and returns its row.
  StudyRow& add_solve_time(const MappedPoses& mapped) const;
};

/// Chains of points with their names.
using NamedChains = std::vector<std::pair<std::string, std::vector<Vec3>>>;
/// Plots the human and robot chains of one frame, seen from the subject's right (forward, up).
Plot pose_plot(const std::string& title, const HumanPose& human, const NamedChains& robots);
/// Returns the joint centres of the arm from the shoulder to the wrist, in the base frame.
std::vector<Vec3> arm_chain_of(const robot::Robot& robot, const JointVector& q);

/// Runs table 1: errors of arms of 6 to 27 joints, 0.9 to 1.3 times as long as the human's.
void run_table_1(const PaperContext& context, StudyResult& result);
/// Runs figs. 5 and 6: 18- and 20-joint arms, 23- and 44-joint arms with a hand.
void run_tracking(const PaperContext& context, StudyResult& result);
/// Runs fig. 4: hands of three to six fingers.
void run_fingers(const PaperContext& context, StudyResult& result);
/// Runs fig. 7: a 21-joint arm from 0.8 to 1.2 times the human's length.
void run_scales(const PaperContext& context, StudyResult& result);
/// Runs fig. 8: a 21-joint arm and the effect of each term.
void run_terms(const PaperContext& context, StudyResult& result);
/// Runs fig. 3: the Barrett WAM by three mappings.
void run_mappings(const PaperContext& context, StudyResult& result);
/// Runs sections 4.1 and 4.2: the PA10, and the PA10 with the DLR/HIT II hand.
void run_reference(const PaperContext& context, StudyResult& result);

}  // namespace morphe::study
