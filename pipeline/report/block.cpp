#include "pipeline/report/block.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/files/base64.hpp"
#include "pipeline/report/json_text.hpp"

namespace morphe::report {
namespace {

constexpr double kMaxSteps = 1099511627776.0;  // 2^40

void append_varint(std::string& bytes, std::uint64_t value) {
  for (; value >= 128; value >>= 7) bytes += static_cast<char>(value % 128 + 128);
  bytes += static_cast<char>(value);
}

std::uint64_t zigzag(std::int64_t value) {
  return value >= 0 ? 2 * static_cast<std::uint64_t>(value)
                    : 2 * static_cast<std::uint64_t>(-value) - 1;
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()),
                               static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw std::runtime_error("zlib could not compress");
  out.resize(size);
  return out;
}

}  // namespace

/// Appends a varint for each number: 0 for NaN, otherwise 1 + the zigzag code of the difference
/// from the linear extrapolation of the two numbers before, in steps.
void Block::add_column(const JointRows& values, Eigen::Index column, double step) {
  std::int64_t last_but_one = 0, last = 0;
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    const double value = values(row, column);
    if (std::isnan(value)) {
      append_varint(bytes_, 0);
      continue;
    }
    const std::int64_t steps = std::llround(std::clamp(value / step, -kMaxSteps, kMaxSteps));
    append_varint(bytes_, zigzag(steps - 2 * last + last_but_one) + 1);
    last_but_one = last;
    last = steps;
  }
}

nlohmann::ordered_json Block::table(const JointRows& values, double step) {
  nlohmann::ordered_json entry = {
      {"array", {values.rows(), values.cols()}}, {"step", step}, {"offset", bytes_.size()}};
  for (Eigen::Index column = 0; column < values.cols(); ++column) add_column(values, column, step);
  return entry;
}

nlohmann::ordered_json Block::column(const std::vector<double>& values, double step) {
  return table(Eigen::Map<const JointVector>(values.data(), values.size()), step);
}

std::string Block::to_base64() const {
  const std::string text = json_text(json);
  std::string header;
  const auto length = static_cast<std::uint32_t>(text.size());
  for (int shift = 0; shift < 32; shift += 8) header += static_cast<char>(length >> shift & 255U);
  return files::encode_base64(deflated(header + text + bytes_));
}

}  // namespace morphe::report
