// Any text is one word, and comes back.
#include <cable_variation/util/encoded_word.h>

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

TEST(EncodedWord, IsOneWordAndComesBack) {
  std::string all;
  for (int c = 0; c < 256; ++c) all += static_cast<char>(c);
  for (const std::string& text :
       {std::string(), std::string("%"), std::string("WH_Start"), std::string("a b\tc\n"), std::string("%20"),
        std::string("Stra\xc3\x9f"
                    "e"),
        all}) {
    const std::string word = encodedWord(text);
    EXPECT_EQ(decodedWord(word), text);
    EXPECT_FALSE(word.empty());
    EXPECT_EQ(word.find_first_of(std::string(" \t\n\v\f\r\0", 7)), std::string::npos) << word;
  }
  EXPECT_EQ(encodedWord("a b%"), "a%20b%25");
}

TEST(EncodedWord, WhatIsNoneIsRefused) {
  for (const char* word : {"%2", "a%", "%2g", "%%", "%-1"})
    EXPECT_THROW(decodedWord(word), std::invalid_argument) << word;
}

}  // namespace
}  // namespace cable_variation
