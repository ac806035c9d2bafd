#include "core/files/table_text.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/files/text_encoding.hpp"

namespace morphe::files {
namespace {

using testing::ElementsAre;

CsvText table(const std::string& text) { return table_from_text("t.csv", text); }

class TableFile : public testing::Test {
 protected:
  CsvText read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return read_table(file_);
  }
  ~TableFile() override { std::filesystem::remove(file_); }
  std::filesystem::path file_ = std::filesystem::path(testing::TempDir()) / "morphe_table.csv";
};

TEST(TableText, SeparatorIsThatOfTheRows) {
  for (const char* text :
       {"t,a x,b\n1,2,3\n4,5,6\n", "t;a x;b\n1;2;3\n4;5;6\n", "t\ta x\tb\n1\t2\t3\n4\t5\t6\n",
        "\"t\";\"a x\";b\n1;2;3\n4;\"5\";6\n"}) {
    const CsvText csv = table(text);
    EXPECT_THAT(csv.cells(1), ElementsAre("t", "a x", "b"));
    EXPECT_THAT(csv.cells(3), ElementsAre("4", "5", "6"));
  }
  const CsvText blanks = table("  t x   y z\n 1  2.5 3 4\n 5 nan  7 8\n");
  EXPECT_THAT(blanks.cells(3), ElementsAre("5", "nan", "7", "8"));
}

TEST(TableText, DecimalCommasAreNumbersUnlessTheySeparate) {
  const CsvText csv = table("t;x;y\n0,5;1,25;-3\n1;2;3\n");
  EXPECT_EQ(csv.value("1,25"), 1.25);
  EXPECT_EQ(csv.value("-3"), -3);
  EXPECT_EQ(csv.value("1.25"), std::nullopt);  // perhaps a thousand
  EXPECT_THAT(csv.notes, ElementsAre("numbers use decimal commas"));
  EXPECT_EQ(table("t,x,y\n0,5,1\n").value("1,25"), std::nullopt);
}

TEST(TableText, QuotesHideASeparator) {
  EXPECT_THAT(table("t,\"wrist, x\",\"a \"\"b\"\"\"\n1,2,3\n").cells(1),
              ElementsAre("t", "wrist  x", "a \"b\""));
}

TEST(TableText, MissingValuesInTheSpellingsOfPrograms) {
  for (const char* cell :
       {"",          "nan",  "NaN",  "-nan",  "Nan",     "NAN",     "inf",     "-inf",
        "Infinity",  "NA",   "#N/A", "#NUM!", "#DIV/0!", "1.#QNAN", "-1.#IND", "nan(ind)",
        "-nan(ind)", "null", "None", "-",     "--",      ".",       "****",    "N/A"}) {
    EXPECT_TRUE(is_missing_value(cell)) << cell;
    EXPECT_TRUE(std::isnan(CsvText{}.number_or_unknown(1, "x", cell))) << cell;
  }
  for (const char* cell : {"0", "-1", "2x", "name", "nano", "inf2", "a-"})
    EXPECT_FALSE(is_missing_value(cell)) << cell;
}

TEST_F(TableFile, CutLastLineIsLeftOut) {
  const std::string rows = "t,x,y\n1,2.25,3.50\n4,5.25,6.50\n";
  EXPECT_EQ(read(rows + "7,8.2").lines.size(), 3u);
  EXPECT_THAT(read(rows + "7,8.2").notes,
              ElementsAre("the last line is cut off in its cell 2 of 3; skipped"));
  EXPECT_EQ(read(rows + "7,8.25,9.50").lines.size(), 4u);  // whole, without a line end
  EXPECT_EQ(read(rows + "7,8.2\n").lines.size(), 4u);      // a wrong row: its reader reports it
}

TEST_F(TableFile, LastNumberWithFewerDecimalsIsCut) {
  std::string text = "t,x,y\n";
  for (int i = 1; i < 12; ++i) text += std::to_string(i) + ",2.2500,3.1250\n";
  EXPECT_EQ(read(text + "12,2.2500,3.1").lines.size(), 12u);
  EXPECT_EQ(read(text + "12,2.2500,3.1250").lines.size(), 13u);
  text.replace(text.rfind("3.1250"), 6, "3.125");  // this writer drops zeros
  EXPECT_EQ(read(text + "12,2.2500,3.1").lines.size(), 13u);
}

TEST_F(TableFile, Utf16IsConverted) {
  const std::string text = "t,Épaule x\n1,2\n";
  for (const bool big : {false, true}) {
    std::string bytes = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char16_t c : std::u16string(u"t,Épaule x\n1,2\n")) {
      const char low = static_cast<char>(c & 0xff), high = static_cast<char>(c >> 8);
      bytes += big ? std::string{high, low} : std::string{low, high};
    }
    EXPECT_THAT(read(bytes).cells(1), ElementsAre("t", "Épaule x")) << big;
    EXPECT_THAT(read(bytes.substr(2)).cells(2), ElementsAre("1", "2")) << "without a mark";
    EXPECT_THAT(read(bytes).notes, ElementsAre("the text is UTF-16; converted"));
  }
}

TEST(TextEncoding, SurrogatesOfUtf16) {
  const std::string pair("\x3D\xD8\x00\xDE", 4), alone("\x3D\xD8\x41\x00", 4);
  EXPECT_EQ(utf8_from_utf16(pair, Utf16Order::little_endian), "\xF0\x9F\x98\x80");
  EXPECT_EQ(utf8_from_utf16(alone, Utf16Order::little_endian),
            "\xEF\xBF\xBD"
            "A");
}

TEST(TableText, FirstLineForRecognition) {
  EXPECT_EQ(first_line_with_commas("\r\n;;\n\"Format Version\";1.23\n1"), "Format Version,1.23");
  EXPECT_EQ(first_line_with_commas(""), "");
}

}  // namespace
}  // namespace morphe::files
