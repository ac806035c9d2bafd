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

/// The hands whose movements are imported from a recording.
enum class HandSelection { right, left, both };
/// Returns the names of the selections.
constexpr std::array<std::string_view, 3> names_of(HandSelection) {
  return {"right", "left", "both"};
}

/// An entry of a manifest. Paths are those written there, joined to the manifest's folder.
struct ManifestEntry {
  std::string manifest;            ///< the manifest that lists it, or ""
  std::string file, static_trial;  ///< static_trial is "" if there is no static trial
  std::string glove, glove_static_trial, glove_calibration;  ///< "" if absent
  std::string name;    ///< "" for the file's name without its extension
  std::string format;  ///< "" to detect it from the content
  std::string names;   ///< YAML map from recorded names to those used here, or ""
  std::string subject, task, source, licence;  ///< metadata, may be ""
  /// `both` only until split_by_hand(); without a value, a clip's own, otherwise right.
  std::optional<HandSelection> hand;
  bool split_from_both = false;  ///< true if the other hand's movements are another entry
  Conventions conventions;
  std::vector<Label> labels;          ///< manually annotated phases
  std::vector<MarkerObject> objects;  ///< objects with markers
  std::optional<double> upper_arm, forearm, hand_length, hand_breadth;  ///< [m]
  /// Assumptions made for it; they are appended to its importer's reports.
  std::vector<std::string> notes;
};

/// Reads a manifest, which lists recordings with the data that their files lack:
///
///     format: vicon-csv            # keys at the top are defaults of every recording
///     recordings:
///       - {file: a.csv, static: a_static.csv, name: a, task: drink}
///
/// A recording of both hands becomes an entry for each. Throws InputError for a missing file key,
/// an unknown key, a length that is not positive or a hand other than right, left and both.
std::vector<ManifestEntry> read_manifest(const std::filesystem::path& file);

/// Splits an entry of both hands into one for each, named NAME_right and NAME_left; any other is
/// returned unchanged.
std::vector<ManifestEntry> split_by_hand(ManifestEntry entry);

/// Returns the side of an entry that is not of both hands; right if it has no hand.
Side side_of(const ManifestEntry& entry);

/// Returns the text of a manifest in `folder` from which read_manifest restores these entries.
std::string manifest_text(std::vector<ManifestEntry> entries, const std::filesystem::path& folder);

/// Returns the schema of a manifest.
config::Schema manifest_schema(const config::KeyDescriptions& meanings);

}  // namespace morphe::imports
