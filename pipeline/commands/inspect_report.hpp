#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/stream_report.hpp"
#include "stages/import/audit/audit_options.hpp"
#include "stages/import/folders/skipped_file.hpp"
#include "stages/import/guess/recording_summary.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::commands {

/// A movement of a recording and its usability.
struct MovementReport {
  Movement movement;
  std::string unusable_reason;       ///< why it cannot be planned, "" if it can
  std::vector<RecordingFlag> flags;  ///< found by the audit of the movement, not of the recording
};

/// The content of a demonstration and the part of it that can be used.
struct Inspection {
  std::string name, subject, task;
  Side hand = Side::right;
  double duration_s = 0;
  std::vector<StreamReport> streams, calibration;
  imports::RecordingSummary survey;  ///< markers or joints, with their body parts
  std::vector<std::string> objects;  ///< names
  /// For shoulder, elbow, wrist and fingertips: the share of frames in which each is reconstructed.
  std::vector<std::pair<std::string, double>> reconstructed_shares;
  std::vector<Residual> residuals;  ///< of the reconstruction
  std::vector<MovementReport> movements;
  std::vector<std::string> estimated;  ///< properties that were estimated instead of recorded
  std::vector<std::string> missing;  ///< properties neither recorded nor estimated, and the effect
  std::vector<RecordingFlag> flags;  ///< of the whole recording
  std::vector<std::string> import_notes, problems;

  /// Returns the number of movements that can be planned.
  std::size_t count_usable() const;
};

/// The options of the stages that inspect() runs.
struct InspectOptions {
  reconstruct::ReconstructOptions reconstruct;
  reconstruct::HumanOptions human;
  segment::SegmentOptions segment;
  imports::AuditOptions audit;
};

/// Reconstructs and segments a demonstration, as `morphe run` does with these options for an arm.
Inspection inspect(const Demonstration& demonstration, const InspectOptions& options);

/// Returns the inspection as a text for display.
std::string inspection_text(const Inspection& inspection);
/// Returns {"demonstrations": […]}, and "skipped": [{file, reason, failed}] if files were skipped.
std::string inspections_json(const std::vector<Inspection>& inspections,
                             const std::vector<imports::SkippedFile>& skipped);

}  // namespace morphe::commands
