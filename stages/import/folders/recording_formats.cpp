#include "stages/import/folders/recording_formats.hpp"

#include "stages/import/clips/readers.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {

const std::vector<RecordingFormat>& recording_formats() {
  static const std::vector<RecordingFormat> formats = {
      {"vicon-csv", &recognises_vicon_csv, &read_vicon_csv},
      {"trc", &recognises_trc, &read_trc},
      {"c3d", &recognises_c3d, &read_c3d},
      {"liberty-csv", &recognises_liberty_csv, &read_liberty_csv},
      {"adroit-csv", &recognises_adroit_csv, &read_adroit_csv, {"axes", "unit", "rate"}},
      {"bvh", &recognises_bvh, &read_bvh},
      {"mot", &recognises_mot, &read_mot, {"axes", "rate"}},
      {"qualisys-tsv", &recognises_qualisys_tsv, &read_qualisys_tsv},
      {"keypoints-csv", &recognises_keypoints_csv, &read_keypoints_csv},
      {"optitrack-csv", &recognises_optitrack_csv, &read_optitrack_csv},
      {"aria-csv", &recognises_aria_csv, &read_aria_csv, {"rate"}},
      {"hot3d", &recognises_hot3d, &read_hot3d, {"rate"}},
      {"mvnx", &recognises_mvnx, &read_mvnx},
      {"manus-csv", &recognises_manus_csv, &read_manus_csv, {"rate"}},
      {"avp-jsonl", &recognises_avp_jsonl, &read_avp_jsonl, {"rate"}},
      {"avp-npz", &recognises_avp_npz, &read_avp_npz},
      {"egodex-hdf5", &recognises_egodex_hdf5, &read_egodex_hdf5},
      {"clip-npz", &recognises_clip_npz, &read_clip_npz},
      {"point-csv", &recognises_point_csv, &read_point_csv},
  };
  return formats;
}

std::vector<std::string> import_format_names() {
  std::vector<std::string> names;
  for (const RecordingFormat& format : recording_formats()) names.push_back(format.name);
  return names;
}

}  // namespace morphe::imports
