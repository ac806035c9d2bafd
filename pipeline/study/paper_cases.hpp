#pragma once

#include <filesystem>

#include "pipeline/study/mapped_poses.hpp"
#include "pipeline/study/paper_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// What every case of the paper's study has.
struct PaperContext {
  PaperStudyOptions options;
  std::filesystem::path robots;  ///< folder
  std::vector<HumanPoses> arms, tips, hands;
  StudyWeights weights;

  double arm_length() const { return options.upper_arm + options.forearm; }
  human::HandSize robot_hand() const {
    return {options.hand_scale * options.hand_length, options.hand_scale * options.hand_breadth};
  }
};

/// All series mapped, one after the other.
MappedPoses map_all(const PaperContext& context, const robot::Robot& robot,
                    const std::vector<HumanPoses>& series, const StudyWeights& weights,
                    const Pose& base_from_shoulder = Pose::Identity());

/// Share of frames whose goals a solve without humanlikeness meets to 0.1 mm and 0.1 degrees.
std::vector<char> reachable(const MappedPoses& plain);

/// Over the frames that `which` marks.
double mean_of(const std::vector<double>& values, const std::vector<char>& which);
double share_of(const std::vector<char>& which);

/// Human and robot chains of one frame, seen from the subject's right (forward, up).
Plot pose_plot(const std::string& title, const HumanPose& human,
               const std::vector<std::pair<std::string, std::vector<Vec3>>>& robots);
/// Joint centres of the arm from the shoulder to the wrist, in the base frame.
std::vector<Vec3> arm_chain_of(const robot::Robot& robot, const JointVector& q);

/// Table 1: end-effector errors of arms of 6 to 27 joints, 0.9 to 1.3 times the human's length.
void table_1(const PaperContext& context, StudyResult& result);
/// Figs. 5, 6: 18- and 20-joint arms, 23- and 44-joint arms with a hand.
void tracking(const PaperContext& context, StudyResult& result);
/// Fig. 4: hands of three to six fingers.
void fingers(const PaperContext& context, StudyResult& result);
/// Fig. 7: a 21-joint arm from 0.8 to 1.2 times the human's length.
void scales(const PaperContext& context, StudyResult& result);
/// Fig. 8: a 21-joint arm and what each term does.
void terms(const PaperContext& context, StudyResult& result);
/// Fig. 3: the Barrett WAM by three mappings.
void mappings(const PaperContext& context, StudyResult& result);
/// 4.1, 4.2: the PA10, and the PA10 with the DLR/HIT II hand.
void reference(const PaperContext& context, StudyResult& result);

}  // namespace morphe::study
