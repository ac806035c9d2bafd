#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/schema.hpp"
#include "core/motion/demonstration.hpp"
#include "stages/import/folders/marker_objects.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// Whose movements a recording is read for.
enum class Hands { right, left, both };
constexpr std::array<std::string_view, 3> names_of(Hands) { return {"right", "left", "both"}; }

/// One line of a manifest. Paths are as written there joined to the manifest's folder.
struct ManifestEntry {
  std::string manifest;                                ///< that lists it; "" = none does
  std::string file, static_trial;                      ///< static: "" = none
  std::string glove, static_glove, glove_calibration;  ///< "" = none
  std::string name;    ///< "" = the file's name without its extension
  std::string format;  ///< "" = by content
  std::string names;   ///< YAML map of recorded names to ours; "" = none
  std::string subject, task, source, licence;
  std::optional<Hands> hand;  ///< both: until hand_by_hand(); none: a clip's own, else right
  bool of_both = false;       ///< the other hand's movements are another entry
  Conventions conventions;
  std::vector<Label> labels;          ///< phases that somebody marked
  std::vector<MarkerObject> objects;  ///< bodies that carry markers
  std::optional<double> upper_arm, forearm, hand_length, hand_breadth;  ///< [m]
  std::vector<std::string> notes;  ///< what was assumed of it: joins what its importer reports
};

/// A manifest lists recordings and says what their files do not:
///
///     format: vicon-csv            # keys at the top are defaults of every recording
///     recordings:
///       - {file: a.csv, static: a_static.csv, name: a, task: drink}
///
/// A recording of both hands becomes an entry of each. Throws InputError for a missing file key, an
/// unknown key, a length that is not positive or a hand that is none of right, left and both.
std::vector<ManifestEntry> read_manifest(const std::filesystem::path& file);

/// An entry of both hands as one of each, called NAME_right and NAME_left; any other as it is.
std::vector<ManifestEntry> hand_by_hand(ManifestEntry entry);

/// Of an entry that is not of both hands; the right one where it says none.
Side side_of(const ManifestEntry& entry);

/// The manifest in `folder` that read_manifest takes back to these entries.
std::string manifest_text(std::vector<ManifestEntry> entries, const std::filesystem::path& folder);

/// What a manifest may hold.
config::Schema manifest_schema(const config::Meanings& meanings);

}  // namespace morphe::imports
