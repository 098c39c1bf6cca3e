#include <cable_variation/util/readable_text.h>

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

using std::string_literals::operator""s;

TEST(ReadableText, KeepsWhatPeopleWrite) {
  for (const std::string text : {"", "length: found '3 mm'", "Tülle Ø 5 µm", "ケーブル", "\xf0\x9f\x94\x8c"})
    EXPECT_EQ(readableText(text), text);
}

TEST(ReadableText, ShowsWhatNobodySees) {
  EXPECT_EQ(readableText("a\0b"s), "a\\x00b");
  EXPECT_EQ(readableText("a\nb\t\x1b[31m\x7f"), "a\\x0ab\\x09\\x1b[31m\\x7f");
  EXPECT_EQ(readableText("T\xfclle"), "T\\xfclle");  // Latin-1
  EXPECT_EQ(readableText("\xff\xfe"
                         "1\0"s),
            "\\xff\\xfe1\\x00");                                        // UTF-16
  EXPECT_EQ(readableText("\xc0\x80"), "\\xc0\\x80");                    // a zero in two bytes
  EXPECT_EQ(readableText("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // half of a surrogate pair
  EXPECT_EQ(readableText("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond U+10FFFF
  EXPECT_EQ(readableText("end \xe3\x82"), "end \\xe3\\x82");            // cut off
}

// Whatever the bytes: one line, without zeros, of bounded length, and what is readable stays as it is.
TEST(ReadableText, OfAnyBytesIsReadable) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string bytes(random() % (trial % 2 == 0 ? 400 : 3000), ' ');
    for (char& byte : bytes) byte = static_cast<char>(random());
    const std::string shown = readableText(bytes);
    EXPECT_LE(shown.size(), 2100U);
    if (shown.size() <= 2000U) {
      EXPECT_EQ(readableText(shown), shown);
    }
    for (const char c : shown) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
  }
}

}  // namespace
}  // namespace cable_variation
