#pragma once

#include <filesystem>

#include "pipeline/study/mapped_poses.hpp"
#include "pipeline/study/paper_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// The data common to all cases of the paper's study.
struct PaperContext {
  /// The options of the study.
  PaperStudyOptions options;
  /// Folder of the robot descriptions.
  std::filesystem::path robots;
  /// The series for arms, for fingertips at a wrist, and for hands alone.
  std::vector<HumanPoses> arms, tips, hands;
  /// The weights of every case that does not set its own.
  StudyWeights weights;

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

/// Computes the mean over the frames that `which` marks.
double mean_of_marked(const std::vector<double>& values, const std::vector<char>& which);
/// Returns the share of marked frames.
double marked_share(const std::vector<char>& which);

/// Plots the human and robot chains of one frame, seen from the subject's right (forward, up).
Plot pose_plot(const std::string& title, const HumanPose& human,
               const std::vector<std::pair<std::string, std::vector<Vec3>>>& robots);
/// Returns the joint centres of the arm from the shoulder to the wrist, in the base frame.
std::vector<Vec3> arm_chain_of(const robot::Robot& robot, const JointVector& q);

/// Runs table 1: end-effector errors of arms of 6 to 27 joints, 0.9 to 1.3 times the human's
/// length.
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
