#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// Writes a C3D file by the book, apart from what a test changes.
struct C3dText {
  int processor = 84;  ///< 84 Intel, 85 DEC, 86 SGI
  double scale = -1;   ///< > 0: integers
  std::string units = "mm";
  std::vector<std::string> labels = {"A", "B"};
  std::vector<std::vector<Vec3>> frames;  ///< [frame][point]; NaN = residual -1
  int analog = 0, analog_per_frame = 0;
  int first = 1;
  double rate_hz = 100;
  std::string x_screen, y_screen;
  std::vector<std::string> angles, moments2;  ///< POINT:ANGLES and POINT:MOMENTS2
  std::size_t extra_frames = 0;               ///< stated, but not in the file
  bool last_pointer_leaves_section = false;
  bool trial_fields = false;

  static constexpr std::size_t kDataBlock = 4;

  std::string text() const {
    const std::size_t points = frames.at(0).size();
    const std::size_t stated = frames.size() + extra_frames;
    const std::size_t last = static_cast<std::size_t>(first) + stated - 1;
    std::string out("\x02\x50", 2);
    for (const std::size_t value : {points, static_cast<std::size_t>(analog),
                                    static_cast<std::size_t>(first), last, std::size_t{0}})
      out += word(value);
    out += real(scale) + word(kDataBlock) + word(static_cast<std::size_t>(analog_per_frame));
    out += real(rate_hz);
    out.resize(512, '\0');
    out += std::string("\x01\x50\x02", 3) + static_cast<char>(processor);
    out += group(1, "POINT") + group(2, "ANALOG") + group(3, "TRIAL");
    out += words(1, "USED", {points}) + reals(1, "RATE", rate_hz) + reals(1, "SCALE", scale);
    out += words(1, "FRAMES", {stated & 0xffff}) + words(1, "DATA_START", {kDataBlock});
    out += texts(1, "LABELS", labels) + texts(1, "UNITS", {units});
    if (!x_screen.empty()) out += texts(1, "X_SCREEN", {x_screen});
    if (!y_screen.empty()) out += texts(1, "Y_SCREEN", {y_screen});
    if (!angles.empty()) out += texts(1, "ANGLES", angles);
    if (!moments2.empty()) out += texts(1, "MOMENTS", {}) + texts(1, "MOMENTS2", moments2);
    const auto channels = static_cast<std::size_t>(analog / std::max(1, analog_per_frame));
    out += words(2, "USED", {channels});
    if (trial_fields) {
      const auto begin = static_cast<std::size_t>(first);
      out += words(3, "ACTUAL_START_FIELD", {begin & 0xffff, begin >> 16});
      out += words(3, "ACTUAL_END_FIELD", {last & 0xffff, last >> 16});
    }
    if (last_pointer_leaves_section) {
      const std::string name = "LAST";
      out += id(4) + id(1) + name + word(2000) + id(2) + id(0) + word(7) + id(0);
    }
    out.resize(512 * (kDataBlock - 1), '\0');
    for (const auto& frame : frames) {
      for (const Vec3& point : frame) {
        for (const double value : {point.x(), point.y(), point.z()}) {
          out += number(is_known(point) ? value : 0);
        }
        out += scale < 0 ? real(is_known(point) ? 0 : -1) : word(is_known(point) ? 0 : 0xffff);
      }
      for (int a = 0; a < analog; ++a) out += number(7);
    }
    return out;
  }

  std::string word(std::size_t value) const {
    const char low = static_cast<char>(value & 0xff), high = static_cast<char>(value >> 8 & 0xff);
    return processor == 86 ? std::string{high, low} : std::string{low, high};
  }
  std::string real(double value) const {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    if (processor == 84) return word(bits & 0xffff) + word(bits >> 16);
    if (processor == 86 || value == 0) return word(bits >> 16) + word(bits & 0xffff);
    // A DEC exponent is two more for the same number: 0.5 <= mantissa < 1, bias 128.
    const std::uint32_t dec = bits + (2u << 23);
    return word(dec >> 16) + word(dec & 0xffff);
  }

 private:
  std::string number(double value) const {
    if (scale < 0) return real(value);
    return word(static_cast<std::size_t>(std::lround(value / scale)) & 0xffff);
  }
  static std::string id(int number) { return {static_cast<char>(number)}; }
  std::string group(int number, const std::string& name) const {
    return id(static_cast<int>(name.size())) + id(-number) + name + word(3) + id(0);
  }
  std::string record(int number, const std::string& name, int type, const std::string& dimensions,
                     const std::string& data) const {
    const std::string rest =
        id(type) + id(static_cast<int>(dimensions.size())) + dimensions + data + id(0);
    return id(static_cast<int>(name.size())) + id(number) + name + word(2 + rest.size()) + rest;
  }
  std::string words(int number, const std::string& name,
                    const std::vector<std::size_t>& values) const {
    std::string data;
    for (const std::size_t value : values) data += word(value);
    return record(number, name, 2, values.size() == 1 ? "" : id(static_cast<int>(values.size())),
                  data);
  }
  std::string reals(int number, const std::string& name, double value) const {
    return record(number, name, 4, "", real(value));
  }
  std::string texts(int number, const std::string& name,
                    const std::vector<std::string>& values) const {
    std::size_t length = 4;
    for (const std::string& value : values) length = std::max(length, value.size());
    std::string data;
    for (std::string value : values) {
      value.resize(length, ' ');
      data += value;
    }
    return record(number, name, -1,
                  id(static_cast<int>(length)) + id(static_cast<int>(values.size())), data);
  }
};

}  // namespace morphe::imports
