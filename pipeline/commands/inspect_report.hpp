#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/stream_report.hpp"
#include "stages/import/folders/skipped_file.hpp"
#include "stages/import/guess/recording_summary.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::commands {

/// A movement of a recording and its usability.
struct MovementReport {
  /// The movement.
  Movement movement;
  /// The reason for which it cannot be planned, "" if it can.
  std::string unusable_reason;
};

/// The content of a demonstration and the part of it that can be used.
struct Inspection {
  /// The name of the demonstration, its subject and its task.
  std::string name, subject, task;
  /// The side of the recorded hand.
  Side hand = Side::right;
  /// The duration [s].
  double duration_s = 0;
  /// The streams of the recording and of the calibration.
  std::vector<StreamReport> streams, calibration;
  /// Summary of its points with the joints to which they were assigned.
  imports::RecordingSummary survey;
  /// The names of the objects.
  std::vector<std::string> objects;
  /// Share of frames in which each point is reconstructed: shoulder … little tip.
  std::vector<std::pair<std::string, double>> reconstructed_shares;
  /// The residuals of the reconstruction.
  std::vector<Residual> residuals;
  /// The movements that were found.
  std::vector<MovementReport> movements;
  /// Properties that were estimated instead of recorded.
  std::vector<std::string> estimated;
  /// Properties neither recorded nor estimated, and the consequences.
  std::vector<std::string> missing;
  /// Reports of the importer.
  std::vector<std::string> import_notes;
  /// The problems of the recording.
  std::vector<std::string> problems;

  /// Returns the number of movements that can be planned.
  std::size_t count_usable() const;
};

/// The options of the stages that are run.
struct InspectOptions {
  /// The options of the reconstruction.
  reconstruct::ReconstructOptions reconstruct;
  /// The options of the human model.
  reconstruct::HumanOptions human;
  /// The options of the segmentation.
  segment::SegmentOptions segment;
};

/// Reconstructs and segments a demonstration as `morphe run` does with these options.
Inspection inspect(const Demonstration& demonstration, const InspectOptions& options);

/// Returns the inspection as a text for display.
std::string inspection_text(const Inspection& inspection);
/// Returns {"demonstrations": […]}, and "left_out": [{file, why, failed}] if files were left out.
std::string inspections_json(const std::vector<Inspection>& inspections,
                             const std::vector<imports::SkippedFile>& skipped);

}  // namespace morphe::commands
