#include "stages/import/formats/c3d_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>

#include "core/motion/input_error.hpp"
#include "stages/import/formats/c3d_parameters.hpp"
#include "stages/import/formats/c3d_quantities.hpp"
#include "stages/import/recording/repeated_names.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

constexpr std::size_t kBlockSize_bytes = 512;
constexpr std::uint8_t kMagic = 0x50;
constexpr double kMaxWord = 65535;  ///< largest value of a field of two bytes

/// The fields of the header. A frame has `analog_values`: for each channel, `samples_per_frame`.
struct C3dHeader {
  std::size_t points, analog_values, first_frame, last_frame, data_block, samples_per_frame;
  double scale, rate_hz;
};

/// The frames of a file: bytes from `start` on, each frame of `size`.
struct FrameBytes {
  const C3dBytes& bytes;
  std::size_t start, size;

  std::size_t all() const { return bytes.size() - std::min(start, bytes.size()); }
  std::size_t count() const { return all() / size; }
  /// Returns true if only zeros follow the last whole frame.
  bool ends_whole() const {
    const std::string_view rest = std::string_view(bytes.bytes).substr(bytes.size() - all() % size);
    return rest.find_first_not_of('\0') == std::string_view::npos;
  }
};

C3dBytes read_bytes(const std::filesystem::path& file) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error))
    throw InputError(fmt::format("{}: cannot be read", file.string()));
  C3dBytes bytes{file.string(), std::string((std::istreambuf_iterator<char>(stream)), {})};
  bytes.require(0, kBlockSize_bytes, "the header");
  if (bytes.byte(1) != kMagic) bytes.fail(1, "must be 0x50: this is not a C3D file");
  return bytes;
}

/// Returns the offset of the parameters, and sets the processor to that which their header states.
std::size_t find_parameters(C3dBytes& bytes) {
  if (bytes.byte(0) == 0) bytes.fail(0, "the parameters must begin at block 1 or later");
  const std::size_t start = (bytes.byte(0) - std::size_t{1}) * kBlockSize_bytes;
  bytes.require(start, kBlockSize_bytes, "the parameter section");
  const std::uint8_t processor = bytes.byte(start + 3);
  if (processor < 84 || processor > 86) {
    bytes.fail(start + 3,
               fmt::format("processor {} is unknown; must be 84 (Intel), 85 (DEC) or 86 (SGI)",
                           processor));
  }
  bytes.processor = static_cast<C3dProcessor>(processor);
  return start;
}

/// Returns the stated number of frames if the file has as many, or one less if it ends with a whole
/// frame: some programs count one too many.
double present_frames(const C3dParameters& parameters, double stated, const FrameBytes& frames,
                      std::vector<std::string>& notes) {
  const double present = static_cast<double>(frames.count());
  if (stated >= 1 && stated <= present) return stated;
  if (present < 1 || stated != present + 1 || !frames.ends_whole()) {
    parameters.fail("POINT:FRAMES",
                    fmt::format("{} frames are stated from byte {} on, but the file has {}", stated,
                                frames.start, present));
  }
  add_note(notes, "{} frames are stated, the file has {}; these were read", stated, present);
  return present;
}

/// Returns the number of frames by the field with the largest range of those that exist, as far as
/// the file has them, and sets points.first_frame. Adds a note if a field states another number.
double frame_count(const C3dHeader& header, const C3dParameters& parameters,
                   const FrameBytes& frames, C3dPoints& points) {
  const double in_header =
      static_cast<double>(header.last_frame) - static_cast<double>(header.first_frame) + 1;
  const double in_point = parameters.number("POINT:FRAMES", in_header);
  double count = parameters.number("POINT:LONG_FRAMES", in_point);
  points.first_frame = header.first_frame;
  const auto start = parameters.numbers("TRIAL:ACTUAL_START_FIELD"),
             end = parameters.numbers("TRIAL:ACTUAL_END_FIELD");
  if (start.size() >= 2 && end.size() >= 2) {
    const double first = start[0] + 65536 * start[1], last = end[0] + 65536 * end[1];
    count = last - first + 1;
    if (!(first >= 0 && first < 65536 * 65536.0))
      parameters.fail("TRIAL:ACTUAL_START_FIELD", fmt::format("{} is not a frame number", first));
    points.first_frame = static_cast<std::size_t>(first);
  }
  count = present_frames(parameters, count, frames, points.import_notes);
  const auto compare = [&](const char* place, double stated) {
    if (stated == count || (count >= kMaxWord && stated <= kMaxWord)) return;
    add_note(points.import_notes, "{} states {} frames; {} were read", place, stated, count);
  };
  compare("the header", in_header);
  compare("POINT:FRAMES", in_point);
  return count;
}

std::size_t analog_count(const C3dHeader& header, const C3dParameters& parameters) {
  const double used = parameters.number("ANALOG:USED", kUnknown);
  const double expected = used * static_cast<double>(header.samples_per_frame);
  if (!std::isnan(expected) && expected != static_cast<double>(header.analog_values)) {
    parameters.fail("ANALOG:USED",
                    fmt::format("{} channels with {} samples per frame contradict "
                                "the {} values per frame of the header",
                                used, header.samples_per_frame, header.analog_values));
  }
  return header.analog_values;
}

double scale_of(const C3dHeader& header, const C3dParameters& parameters) {
  const double scale = parameters.number("POINT:SCALE", header.scale);
  if (!std::isfinite(scale) || scale == 0 || (scale < 0) != (header.scale < 0)) {
    parameters.fail("POINT:SCALE",
                    fmt::format("{} here and {} in the header contradict each other on whether "
                                "points are floats or integers",
                                scale, header.scale));
  }
  return scale;
}

/// Returns the offset of the first frame. If both POINT:DATA_START and the header state block 0, as
/// OptiTrack's Motive writes, the first frame is at `block_after_parameters`.
std::size_t data_start(const C3dHeader& header, const C3dParameters& parameters,
                       std::size_t block_after_parameters, std::vector<std::string>& reports) {
  const auto in_header = static_cast<double>(header.data_block);
  double block = parameters.number("POINT:DATA_START", in_header);
  if (block == 0 && in_header == 0) {
    add_note(reports,
             "neither the header nor POINT:DATA_START states where points begin; read from block "
             "{}, after the parameters",
             block_after_parameters);
    return (block_after_parameters - 1) * kBlockSize_bytes;
  }
  if (block == 0) block = in_header;
  if (!(block >= 2 && block <= kMaxWord))
    parameters.fail("POINT:DATA_START", fmt::format("no points at block {}", block));
  if (block != in_header) {
    add_note(reports,
             "points begin at block {} according to the header; they were read from block {}, "
             "according to POINT:DATA_START",
             in_header, block);
  }
  return (static_cast<std::size_t>(block) - 1) * kBlockSize_bytes;
}

/// Reads LABELS, LABELS2, …, of at most 255 names each. Without a name, the fourth point is "*4".
std::vector<std::string> read_labels(const C3dParameters& parameters, std::size_t points,
                                     std::vector<std::string>& reports) {
  std::vector<std::string> labels = parameters.texts("POINT:LABELS");
  for (int more = 2; parameters.has(fmt::format("POINT:LABELS{}", more)); ++more) {
    const auto next = parameters.texts(fmt::format("POINT:LABELS{}", more));
    labels.insert(labels.end(), next.begin(), next.end());
  }
  const std::size_t named = labels.size();
  labels.resize(points);
  int unnamed = 0;
  for (std::size_t k = 0; k < points; ++k) {
    if (labels[k].empty()) {
      labels[k] = fmt::format("*{}", k + 1);
      ++unnamed;
    }
  }
  if (unnamed > 0) add_note(reports, "points without a name: {}", unnamed);
  if (named > points)
    add_note(reports, "POINT:LABELS has {} names, but there are {} points", named, points);
  return labels;
}

/// Reads the points of all frames, each with its residual, which is below 0 if it was not seen.
void read_points(const C3dBytes& bytes, std::size_t start, std::size_t frame_bytes, double scale,
                 Array2D<Vec3>& position) {
  for (std::size_t i = 0; i < position.rows; ++i) {
    for (std::size_t k = 0; k < position.cols; ++k) {
      const std::size_t offset = start + i * frame_bytes + k * (scale < 0 ? 16 : 8);
      const auto value = [&](std::size_t n) {
        return scale < 0 ? static_cast<double>(bytes.real(offset + 4 * n))
                         : static_cast<double>(bytes.integer(offset + 2 * n));
      };
      const Vec3 point = Vec3(value(0), value(1), value(2)) * (scale < 0 ? 1 : scale);
      if (value(3) >= 0 && is_known(point)) position(i, k) = point;
    }
  }
}

}  // namespace

C3dPoints read_c3d_points(const std::filesystem::path& file) {
  C3dBytes bytes = read_bytes(file);
  const std::size_t parameter_start = find_parameters(bytes);
  const C3dHeader header{bytes.word(2),  bytes.word(4),  bytes.word(6),  bytes.word(8),
                         bytes.word(16), bytes.word(18), bytes.real(12), bytes.real(20)};
  const std::size_t next_block = bytes.byte(0) + std::size_t{bytes.byte(parameter_start + 2)};
  // Some programs state too few blocks for the parameters; the data follow them in any case.
  const std::size_t section_end = (std::max(next_block, header.data_block) - 1) * kBlockSize_bytes;
  const C3dParameters parameters(bytes, parameter_start, section_end);
  const double used = parameters.number("POINT:USED", static_cast<double>(header.points));
  if (header.points == 0 || used != static_cast<double>(header.points)) {
    parameters.fail("POINT:USED",
                    fmt::format("{} points here, {} in the header", used, header.points));
  }
  C3dPoints points;
  points.labels = read_labels(parameters, header.points, points.import_notes);
  const std::vector<std::string> quantities = listed_quantities(parameters, points.labels);
  number_repeated_names(points.labels, points.import_notes);
  points.unit = parameters.text("POINT:UNITS");
  points.x_screen = parameters.text("POINT:X_SCREEN");
  points.y_screen = parameters.text("POINT:Y_SCREEN");
  points.rate_hz = parameters.number("POINT:RATE", header.rate_hz);
  const double scale = scale_of(header, parameters);
  const std::size_t start = data_start(header, parameters, next_block, points.import_notes);
  const std::size_t frame_bytes =
      (4 * header.points + analog_count(header, parameters)) * (scale < 0 ? 4 : 2);
  const double frames =
      frame_count(header, parameters, FrameBytes{bytes, start, frame_bytes}, points);
  points.position = Array2D<Vec3>(static_cast<std::size_t>(frames), header.points, unknown_point());
  read_points(bytes, start, frame_bytes, scale, points.position);
  remove_quantities(parameters, quantities, points);
  const std::size_t rest = bytes.size() - start - points.position.rows * frame_bytes;
  if (rest >= kBlockSize_bytes)
    add_note(points.import_notes, "{} bytes after the last frame skipped", rest);
  return points;
}

}  // namespace morphe::imports
