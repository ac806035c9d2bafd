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

// The beginnings of notes of a ManifestEntry that the summary of an import counts.
inline constexpr std::string_view kNoStaticTrial = "no static trial found";
inline constexpr std::string_view kMovingStaticTrial = "named like a static trial";

/// An entry of a manifest. A relative path in the manifest begins at the manifest's folder.
struct ManifestEntry {
  std::string manifest;            ///< the manifest that lists it, or ""
  std::string file, static_trial;  ///< static_trial is "" if there is no static trial
  std::string glove, glove_static_trial, glove_calibration;  ///< "" if absent
  std::string name;    ///< "" for the file's name without its extension
  std::string format;  ///< "" to detect it from the content
  std::string names;   ///< YAML file that maps recorded names to Morphe's, or ""
  std::string subject, task, source, licence;  ///< metadata, may be ""
  /// `both` only before split_by_hand(); without a value, the one that a clip states, or right.
  std::optional<HandSelection> hand;
  bool split_from_both = false;  ///< true if the other hand's movements are another entry
  Conventions conventions;
  std::vector<Label> labels;  ///< manually annotated phases
  std::vector<MarkerObject> objects;
  std::optional<double> upper_arm, forearm, hand_length, hand_breadth;  ///< [m]
  std::vector<FlagCode> accept;    ///< flags of the audit that the user has answered
  std::vector<std::string> notes;  ///< assumptions, appended to Demonstration::import_notes
};
/// Returns the fields that name a file; those of absent files are "".
std::vector<std::string*> paths_of(ManifestEntry& entry);

/// Reads a manifest, which lists recordings with the data that their files lack:
///
///     format: vicon-csv            # keys at the top are defaults of every recording
///     recordings:
///       - {file: a.csv, static_trial: a_static.csv, name: a, task: drink}
///
/// A recording with `hand: both` becomes an entry for each hand. Throws InputError for a missing
/// file key, an unknown key, a length or rate that is not positive, and other invalid values.
std::vector<ManifestEntry> read_manifest(const std::filesystem::path& file);

/// Splits an entry with `both` into NAME_right and NAME_left; returns any other entry unchanged.
std::vector<ManifestEntry> split_by_hand(ManifestEntry entry);

/// Returns left for an entry of the left hand, otherwise right.
Side side_of(const ManifestEntry& entry);

/// Returns the text from which read_manifest() restores these entries if it is saved in `folder`.
std::string manifest_text(std::vector<ManifestEntry> entries, const std::filesystem::path& folder);

/// Returns the schema of a manifest. `meanings` describe its keys.
config::Schema manifest_schema(const config::KeyDescriptions& meanings);

}  // namespace morphe::imports
