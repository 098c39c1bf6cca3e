// Bytes as text: against the vectors of the standards that define them.
#include <cable_variation/util/base64.h>
#include <cable_variation/util/sha256.h>
#include <cable_variation/util/version.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

TEST(Sha256, IsThatOfTheStandardsExamples) {
  // FIPS 180-2, appendix B, and NIST's vector of the empty message
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, TellsEveryLengthAndByteApart) {
  std::string bytes;
  std::vector<std::string> all;
  for (int i = 0; i < 130; ++i) {  // over two ends of blocks
    all.push_back(sha256(bytes));
    bytes += '\0';
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::unique(all.begin(), all.end()), all.end());
}

TEST(Base64, IsThatOfTheStandardsExamples) {
  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfb\x00\x10", 4)), "//sAEA==");
}

TEST(PackageVersion, IsThatOfThePackage) {
  std::ifstream file(std::string(CABLE_VARIATION_SOURCE_DIR) + "/package.xml");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find("<version>" + std::string(packageVersion()) + "</version>"), std::string::npos);
}

}  // namespace
}  // namespace cable_variation
