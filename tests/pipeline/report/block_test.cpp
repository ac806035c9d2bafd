#include "pipeline/report/block.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <random>

#include "core/files/base64.hpp"
#include "pipeline/report/json_text.hpp"

namespace morphe::report {
namespace {

using Json = nlohmann::ordered_json;

std::string from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(letters.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 255U);
  }
  return bytes;
}

std::string inflated(const std::string& packed) {
  std::string bytes(1U << 22U, '\0');
  uLongf size = bytes.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  bytes.resize(size);
  return bytes;
}

/// A block as a reader sees it, who has README.md alone.
struct Read {
  Json json;
  std::string bytes;

  explicit Read(const Block& block) {
    const std::string whole = inflated(from_base64(block.to_base64()));
    std::size_t length = 0;
    for (std::size_t i = 4; i-- > 0;) length = length * 256 + static_cast<unsigned char>(whole[i]);
    json = Json::parse(whole.substr(4, length));
    bytes = whole.substr(4 + length);
  }
  JointRows table(const Json& entry) const {
    JointRows values(entry["array"][0].get<int>(), entry["array"][1].get<int>());
    std::size_t at = entry["offset"].get<std::size_t>();
    for (Eigen::Index column = 0; column < values.cols(); ++column) {
      double before = 0, last = 0;
      for (Eigen::Index row = 0; row < values.rows(); ++row) {
        double code = 0, weight = 1;
        unsigned char byte = 128;
        while (byte >= 128) {
          byte = static_cast<unsigned char>(bytes[at++]);
          code += (byte & 127) * weight;
          weight *= 128;
        }
        values(row, column) = kUnknown;
        if (code == 0) continue;
        const double zigzag = code - 1;
        const double change = std::fmod(zigzag, 2) == 0 ? zigzag / 2 : -(zigzag + 1) / 2;
        const double whole = change + 2 * last - before;
        before = last;
        last = whole;
        values(row, column) = whole * entry["step"].get<double>();
      }
    }
    return values;
  }
};

TEST(Base64, IsThatOfRfc4648) {
  const std::vector<std::pair<std::string, std::string>> known{{"", ""},
                                                               {"f", "Zg=="},
                                                               {"fo", "Zm8="},
                                                               {"foo", "Zm9v"},
                                                               {"foob", "Zm9vYg=="},
                                                               {"fooba", "Zm9vYmE="},
                                                               {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : known) EXPECT_EQ(files::encode_base64(bytes), text);
}

TEST(Base64, TakesWhatIsLongerThanItsBlocks) {
  std::string bytes(7'000'001, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7 % 251);
  EXPECT_EQ(from_base64(files::encode_base64(bytes)), bytes);
}

TEST(Block, GivesEveryNumberBackToHalfAStep) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  JointRows values(200, 5);
  for (double& value : values.reshaped()) value = 10 * normal(random);
  values.row(17).setConstant(kUnknown);
  values(0, 2) = kUnknown;
  values(199, 4) = kUnknown;
  values(60, 0) = -4e6;
  Block block;
  block.json["first"] = block.table(values, 1e-4);
  block.json["second"] = block.integer_column(std::vector<int>{0, -1, 255, 3});
  const Read read(block);
  const JointRows back = read.table(read.json["first"]);
  ASSERT_EQ(back.rows(), 200);
  for (Eigen::Index row = 0; row < 200; ++row) {
    for (Eigen::Index col = 0; col < 5; ++col) {
      if (std::isnan(values(row, col)))
        EXPECT_TRUE(std::isnan(back(row, col)));
      else
        EXPECT_NEAR(back(row, col), values(row, col), 0.5e-4 + 1e-9);
    }
  }
  EXPECT_THAT(read.table(read.json["second"]).reshaped(), testing::ElementsAre(0, -1, 255, 3));
}

TEST(Block, BoundsWhatNoStepCounts) {
  Block block;
  block.json["table"] = block.column({kInfinity, -kInfinity, 1e300, 0}, 1);
  const Read read(block);
  const double most = std::pow(2, 40);
  EXPECT_THAT(read.table(read.json["table"]).reshaped(),
              testing::ElementsAre(most, -most, most, 0));
}

TEST(JsonText, CannotEndAScript) {
  const std::string hostile = "</script><img src=x onerror=alert(1)>&amp;<!--\xff\x01";
  const std::string text = json_text({{hostile, hostile}});
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  const Json back = Json::parse(text);
  EXPECT_EQ(back.begin().value(), "</script><img src=x onerror=alert(1)>&amp;<!--\uFFFD\x01");
}

}  // namespace
}  // namespace morphe::report
