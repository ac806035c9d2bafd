#include "core/files/printable.hpp"

#include <gtest/gtest.h>

namespace morphe::files {
namespace {

TEST(Printable, TextStaysAndControlCharactersAreSpelled) {
  EXPECT_EQ(make_printable("Grüße, 手, 🖐 and é"), "Grüße, 手, 🖐 and é");
  EXPECT_EQ(make_printable("red \x1b[31m"), "red \\u001b[31m");
  EXPECT_EQ(make_printable(std::string_view("a\0b\x7f", 4)), "a\\u0000b\\u007f");
  EXPECT_EQ(make_printable("c1 \xc2\x9b"), "c1 \\u009b");
  EXPECT_EQ(make_printable("turned \xe2\x80\xae"), "turned \\u202e");
  EXPECT_EQ(make_printable("line\nend\tof\r"), "line\\u000aend\\u0009of\\u000d");
  EXPECT_EQ(make_printable("line\nend\tof\r", "\n\t"), "line\nend\tof\\u000d");
  EXPECT_TRUE(is_printable("Grüße"));
  EXPECT_FALSE(is_printable("a\nb"));
}

TEST(Printable, WhatIsNoUtf8IsSpelledByteByByte) {
  EXPECT_EQ(make_printable("\xff\xc3\x28"), "\\xff\\xc3(");
  EXPECT_EQ(make_printable("cut \xe2\x80"), "cut \\xe2\\x80");
  EXPECT_EQ(make_printable("\xc0\xaf \xed\xa0\x80"),
            "\\xc0\\xaf \\xed\\xa0\\x80");  // overlong, surrogate
}

TEST(Printable, ALetterThatIsNotWholeYet) {
  const std::string hand = "a🖐";
  EXPECT_EQ(incomplete_utf8_bytes(hand), 0u);
  for (std::size_t left = 1; left <= 3; ++left)
    EXPECT_EQ(incomplete_utf8_bytes(hand.substr(0, hand.size() - left)), 4 - left);
  EXPECT_EQ(incomplete_utf8_bytes(""), 0u);
  EXPECT_EQ(incomplete_utf8_bytes("\x80\x80\x80\x80"), 0u);
}

}  // namespace
}  // namespace morphe::files
