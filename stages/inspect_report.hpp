#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/motion/demonstration.hpp"
#include "pipeline/motion/human_motion.hpp"
#include "pipeline/motion/movement.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe {

/// One recorded stream. A gap is a run of samples in which one of its columns (a marker, a body, a
/// joint) was not seen, at the ends too.
struct StreamReport {
  std::string name;
  double begin_s = 0, duration_s = 0, rate_hz = 0;
  double seen = 0;  ///< share of its values that are there
  std::size_t columns = 0, gaps = 0;
  double longest_gap_s = 0;
  std::string longest_gap_of;       ///< the column, "" without a gap
  std::vector<std::string> unseen;  ///< columns that were never seen
};

struct MovementReport {
  Movement movement;
  std::string unusable;  ///< why it cannot be planned, "" if it can
};

/// What a demonstration holds and what of it will be usable.
struct Inspection {
  std::string name, subject, task, hand;
  double duration_s = 0;
  std::vector<StreamReport> streams, calibration;
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
  ReconstructOptions reconstruct;
  HumanOptions human;
  SegmentOptions segment;
};

/// Rebuilds and segments it as `morphe run` would with these options.
Inspection inspect(const Demonstration& demonstration, const InspectOptions& options);

std::string inspection_text(const Inspection& inspection);
/// {"demonstrations": […]}
std::string inspections_json(const std::vector<Inspection>& inspections);

}  // namespace morphe
