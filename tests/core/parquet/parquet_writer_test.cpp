#include "core/parquet/parquet_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/motion/input_error.hpp"
#include "core/parquet/column_chunk.hpp"
#include "core/parquet/thrift_compact.hpp"

namespace morphe::parquet {
namespace {

std::string hex(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : bytes) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 0xF];
  }
  return text;
}

// The values are those of the specification of Thrift's compact protocol.
TEST(ThriftWriter, EncodesFieldsAsTheProtocolSays) {
  ThriftWriter out;
  out.integer(1, ThriftWriter::Type::i32, 0);
  out.integer(2, ThriftWriter::Type::i32, 34);
  out.integer(5, ThriftWriter::Type::i64, -1);
  out.text(6, "ab");
  out.begin_list(7, ThriftWriter::Type::i32, 2);
  out.integer_element(0);
  out.integer_element(150);
  out.begin_struct(10);
  out.integer(1, ThriftWriter::Type::i32, 1);
  out.end_struct();
  out.end_struct();
  EXPECT_EQ(hex(out.bytes()), "15001544360118026162192500ac023c15020000");
}

TEST(ThriftWriter, ALongListHasItsLengthBehindItsType) {
  ThriftWriter out;
  out.begin_list(1, ThriftWriter::Type::i32, 15);
  EXPECT_EQ(hex(out.bytes()), "19f50f");
}

TEST(EncodeLevels, EqualLevelsAreOneRun) {
  const std::vector<std::uint8_t> levels(300, 3);
  EXPECT_EQ(hex(encode_levels(levels, 2)), "03000000d80403");
}

TEST(EncodeLevels, OthersArePackedLowestBitFirst) {
  // Ten levels of one bit: two groups of eight, the second one padded.
  EXPECT_EQ(hex(encode_levels(std::vector<std::uint8_t>{0, 1, 1, 1, 0, 1, 1, 1, 0, 1}, 1)),
            "0300000005ee02");
  // Packs two bits a value: 3, 0, 1, 2 are 0b10'01'00'11.
  EXPECT_EQ(hex(encode_levels(std::vector<std::uint8_t>{3, 0, 1, 2}, 2)), "03000000039300");
}

TEST(ColumnChunk, HasLevelsForNullsEmptyListsAndNullElements) {
  ColumnChunk chunk({"a", ValueType::float32, true});
  chunk.add_numbers(std::vector<double>{1, std::nan("")});
  chunk.add_numbers(std::vector<double>{});
  chunk.add_null();
  EXPECT_EQ(chunk.value_count(), 4u);
  // Repetition 0 1 0 0; definition 3 2 1 0; one float.
  EXPECT_EQ(hex(chunk.page_body()),
            "020000000302030000000"
            "31b00"
            "0000803f");
}

TEST(ColumnChunk, PacksBooleans) {
  ColumnChunk chunk({"a", ValueType::boolean, false});
  for (const bool value : {true, false, true}) chunk.add_boolean(value);
  EXPECT_EQ(hex(chunk.page_body()), "02000000060105");
}

class ParquetFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file); }
  std::string content() const {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("table_" + std::to_string(getpid()));
};

TEST_F(ParquetFile, BeginsAndEndsAsReadersExpect) {
  ParquetWriter writer(file, "table", {{"a", ValueType::float32, true}, {"i", ValueType::int64}});
  for (const int row : {0, 1}) {
    writer.add_numbers(std::vector<double>{1.0 + 2 * row, 2.0 + 2 * row});
    writer.add_integer(row);
  }
  writer.finish();
  const std::string bytes = content();
  // Read back as [[1, 2], [3, 4]] and [0, 1] by hyparquet and DuckDB. The page of `a`:
  // four values, plain; repetition 0 1 0 1, definition four times 3, four floats.
  EXPECT_TRUE(
      hex(bytes).starts_with("50415231"
                             "150015381538"
                             "2c15081500150615060000"
                             "02000000030a"
                             "020000000803"
                             "0000803f000000400000404000008040"))
      << hex(bytes).substr(0, 140);
  EXPECT_TRUE(bytes.ends_with("PAR1"));
  std::uint32_t metadata = 0;
  for (int k = 0; k < 4; ++k)
    metadata |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[bytes.size() - 8 + k]))
                << 8 * k;
  EXPECT_LT(metadata, bytes.size());
  EXPECT_EQ(hex(bytes.substr(bytes.size() - 8 - metadata, 4)),
            "1504195c");  // version 2, 5 elements
}

TEST_F(ParquetFile, MemoryDoesNotGrowWithRows) {
  ParquetWriter writer(file, "table", {{"text", ValueType::text}});
  const std::string text(1 << 16, 'x');
  for (int row = 0; row < 1000; ++row) writer.add_text(text);
  const std::uint64_t written = std::filesystem::file_size(file);
  EXPECT_GT(written, 1000 * text.size() - 2 * ParquetWriter::kRowGroupBytes);
  EXPECT_GE(writer.size(), written);
  writer.finish();
  EXPECT_GE(std::filesystem::file_size(file), 1000 * text.size());
}

TEST_F(ParquetFile, SaysThatTheDiskIsFull) {
  try {
    ParquetWriter writer("/dev/full", "here/table.parquet", {{"a", ValueType::int64}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "here/table.parquet: cannot be written: No space left on device");
  }
}

}  // namespace
}  // namespace morphe::parquet
