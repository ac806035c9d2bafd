#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/stream_report.hpp"
#include "stages/import/folders/left_out.hpp"
#include "stages/import/guess/survey.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::commands {

struct MovementReport {
  Movement movement;
  std::string unusable;  ///< why it cannot be planned, "" if it can
};

/// What a demonstration holds and what of it will be usable.
struct Inspection {
  std::string name, subject, task;
  Side hand = Side::right;
  double duration_s = 0;
  std::vector<StreamReport> streams, calibration;
  imports::Survey survey;  ///< its points and what they are taken for
  std::vector<std::string> objects;
  std::vector<std::pair<std::string, double>> rebuilt;  ///< share of frames: shoulder … little tip
  std::vector<Residual> residuals;
  std::vector<MovementReport> movements;
  std::vector<std::string> estimated;  ///< not recorded
  std::vector<std::string> missing;    ///< neither recorded nor estimated, and what that costs
  std::vector<std::string> reports;    ///< of the importer
  std::vector<std::string> problems;

  std::size_t usable() const;
};

struct InspectOptions {
  reconstruct::ReconstructOptions reconstruct;
  reconstruct::HumanOptions human;
  segment::SegmentOptions segment;
};

/// Rebuilds and segments it as `morphe run` would with these options.
Inspection inspect(const Demonstration& demonstration, const InspectOptions& options);

std::string inspection_text(const Inspection& inspection);
/// {"demonstrations": […]}, and "left_out": [{file, why, failed}] if something was.
std::string inspections_json(const std::vector<Inspection>& inspections,
                             const std::vector<imports::LeftOut>& left_out);

}  // namespace morphe::commands
