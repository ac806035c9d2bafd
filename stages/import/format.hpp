#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/motion/demonstration.hpp"
#include "stages/import/conventions.hpp"

namespace morphe::imports {

/// One recording on disk and what belongs to it.
struct RecordingFiles {
  std::filesystem::path file;
  std::filesystem::path static_trial;          ///< or calibration pose; empty = none
  std::filesystem::path glove, static_glove;   ///< of their own, beside the two; empty = none
  std::filesystem::path glove_calibration;     ///< YAML, for raw counts; empty = none
  std::map<std::string, std::string> renamed;  ///< recorded marker or joint name -> name used here
  Side hand = Side::right;                     ///< which one was recorded
  Conventions conventions;                     ///< what the file itself does not say
};

/// A recording format: `recognises` judges the first bytes of a file (without a UTF-8 mark), `read`
/// fills the streams, the calibration and the objects (and what else the file says: the subject),
/// in the world frame and in metres, and says in `reports` what it assumed or repaired. InputError
/// for what is not exactly what the format says, NotSaid for axes, a unit or a rate that neither
/// the file nor `conventions` gives, or that cannot be right: import_question.hpp asks for them all
/// at once.
struct RecordingFormat {
  std::string name;
  bool (*recognises)(std::string_view head);
  Demonstration (*read)(const RecordingFiles& files);
};

/// Every format there is: one line each, in the order in which they are tried.
const std::vector<RecordingFormat>& recording_formats();

bool recognises_vicon_csv(std::string_view head);
Demonstration read_vicon_csv(const RecordingFiles& files);

bool recognises_trc(std::string_view head);
Demonstration read_trc(const RecordingFiles& files);

bool recognises_c3d(std::string_view head);
Demonstration read_c3d(const RecordingFiles& files);

bool recognises_liberty_csv(std::string_view head);
Demonstration read_liberty_csv(const RecordingFiles& files);

bool recognises_adroit_csv(std::string_view head);
Demonstration read_adroit_csv(const RecordingFiles& files);

bool recognises_bvh(std::string_view head);
Demonstration read_bvh(const RecordingFiles& files);

bool recognises_mot(std::string_view head);
Demonstration read_mot(const RecordingFiles& files);

bool recognises_qualisys_tsv(std::string_view head);
Demonstration read_qualisys_tsv(const RecordingFiles& files);

bool recognises_point_csv(std::string_view head);
Demonstration read_point_csv(const RecordingFiles& files);

bool recognises_keypoints_csv(std::string_view head);
Demonstration read_keypoints_csv(const RecordingFiles& files);

bool recognises_optitrack_csv(std::string_view head);
Demonstration read_optitrack_csv(const RecordingFiles& files);

bool recognises_aria_csv(std::string_view head);
Demonstration read_aria_csv(const RecordingFiles& files);

bool recognises_hot3d(std::string_view head);
Demonstration read_hot3d(const RecordingFiles& files);

bool recognises_mvnx(std::string_view head);
Demonstration read_mvnx(const RecordingFiles& files);

bool recognises_manus_csv(std::string_view head);
Demonstration read_manus_csv(const RecordingFiles& files);

bool recognises_avp_jsonl(std::string_view head);
Demonstration read_avp_jsonl(const RecordingFiles& files);

bool recognises_avp_npz(std::string_view head);
Demonstration read_avp_npz(const RecordingFiles& files);

bool recognises_egodex_hdf5(std::string_view head);
Demonstration read_egodex_hdf5(const RecordingFiles& files);

bool recognises_clip_npz(std::string_view head);
Demonstration read_clip_npz(const RecordingFiles& files);
/// Whether any array of a .npz is called as one that only a clip has. InputError if it has no
/// directory of arrays.
bool holds_a_clip(const std::filesystem::path& file);
/// The hand that reaches, if the clip says it.
std::optional<Side> clip_hand(const std::filesystem::path& file);

}  // namespace morphe::imports
