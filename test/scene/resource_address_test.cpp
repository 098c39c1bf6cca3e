#include <cable_variation/scene/resource_address.h>

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

// A folder that is the package 'parts', and one with a blank in its own path, 'other parts'.
class Addresses : public testing::Test {
 protected:
  Addresses() : root_(fs::temp_directory_path() / (std::to_string(getpid()) + "_addresses")) {
    fs::create_directories(root_ / "parts" / "meshes");
    fs::create_directories(root_ / "other parts");
  }
  ~Addresses() override { fs::remove_all(root_); }

  void touch(const std::string& below) const { std::ofstream(root_ / below) << "x"; }

  ResourceFile find(const std::string& address, std::uintmax_t most = kAnySize) const {
    return findResource(
        address,
        [this](const std::string& package) {
          if (package == "parts") return (root_ / "parts").string();
          return package == "others" ? (root_ / "other parts").string() : std::string();
        },
        most);
  }

  std::string refusal(const std::string& address, std::uintmax_t most = kAnySize) const {
    try {
      find(address, most);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  fs::path root_;
};

TEST_F(Addresses, plainOnesStayAsTheyAre) {
  touch("parts/meshes/part-1_a.b~c+d.stl");
  const std::string address = "package://parts/meshes/part-1_a.b~c+d.stl";
  EXPECT_EQ(find(address).url, address);
  EXPECT_EQ(find(address).path, (root_ / "parts/meshes/part-1_a.b~c+d.stl").string());
  EXPECT_EQ(find("file://" + (root_ / "parts/meshes/part-1_a.b~c+d.stl").string()).url,
            "file://" + (root_ / "parts/meshes/part-1_a.b~c+d.stl").string());
}

// Written plainly or escaped, an address names the same file, and its URL is the escaped form.
TEST_F(Addresses, specialCharactersMayBeEscapedOrNot) {
  const std::vector<std::pair<std::string, std::string>> names{
      {"a b.stl", "a%20b.stl"},
      {"a#b.stl", "a%23b.stl"},
      {"100%.stl", "100%25.stl"},
      {"50% off.stl", "50%25%20off.stl"},
      {"why?.stl", "why%3F.stl"},
      {"M\xc3\xbc"
       "ll.stl",
       "M%C3%BCll.stl"},
      {"a&b=c;d.stl", "a%26b%3Dc%3Bd.stl"},
      {"[x] (y) {z}.stl", "%5Bx%5D%20%28y%29%20%7Bz%7D.stl"},
      {"a:b|c.stl", "a%3Ab%7Cc.stl"}};
  for (const auto& [plain, escaped] : names) {
    touch("parts/meshes/" + plain);
    for (const std::string& written : {plain, escaped}) {
      const ResourceFile file = find("package://parts/meshes/" + written);
      EXPECT_EQ(file.path, (root_ / "parts/meshes" / plain).string()) << written;
      EXPECT_EQ(file.url, "package://parts/meshes/" + escaped) << written;
    }
  }
}

TEST_F(Addresses, whereBothAreThereTheUrlsMeaningCounts) {
  touch("parts/a b.stl");
  touch("parts/a%20b.stl");
  EXPECT_EQ(find("package://parts/a%20b.stl").path, (root_ / "parts/a b.stl").string());
  EXPECT_EQ(find("package://parts/a%2520b.stl").path, (root_ / "parts/a%20b.stl").string());
  EXPECT_EQ(find("package://parts/a%2520b.stl").url, "package://parts/a%2520b.stl");
}

TEST_F(Addresses, aPackageWhosePathIsNotPlainIsNamedByFile) {
  touch("other parts/a.stl");
  EXPECT_EQ(find("package://others/a.stl").url, "file://" + (root_.string() + "/other%20parts/a.stl"));
}

TEST_F(Addresses, dotsAreResolvedInTheText) {
  touch("parts/a.stl");
  touch("other parts/b.stl");
  EXPECT_EQ(find("package://parts/meshes/../a.stl").url, "package://parts/a.stl");
  EXPECT_EQ(find("package://parts//./meshes/..//a.stl").url, "package://parts/a.stl");
  EXPECT_EQ(find("package://parts/../other%20parts/b.stl").url,
            "file://" + (root_.string() + "/other%20parts/b.stl"));
}

TEST_F(Addresses, whatIsNoFileIsRefusedAtOnce) {
  touch("parts/a.stl");
  ASSERT_EQ(mkfifo((root_ / "parts/pipe.stl").c_str(), 0600), 0);
  const auto ends = [&](const std::string& address, const std::string& part, std::uintmax_t most = kAnySize) {
    EXPECT_NE(refusal(address, most).find("'" + address + "' " + part), std::string::npos)
        << refusal(address, most);
  };
  ends("package://parts/pipe.stl", "is a named pipe; expected a file (looked for ");
  ends("package://parts/meshes", "is a folder; expected a file (looked for ");
  ends("package://parts/b.stl", "does not exist (looked for ");
  ends("package://parts/a%00.stl", "does not exist (looked for ");
  ends("package://parts/a.stl/b.stl", "does not exist (looked for ");
  ends("package://parts/" + std::string(5000, 'a') + ".stl", "does not exist (looked for ");
  ends("package://parts/a.stl", "has 0.001 kB; expected at most 0 kB (looked for ", 0);
  EXPECT_EQ(refusal("file:///dev/zero"), "'file:///dev/zero' is a device; expected a file");
  EXPECT_EQ(refusal("file:///nowhere/a.stl"), "'file:///nowhere/a.stl' does not exist");
  EXPECT_EQ(refusal("package://nowhere/a.stl"),
            "package 'nowhere' of 'package://nowhere/a.stl' was not found");
  for (const std::string address :
       {"package://", "package://parts", "package://parts/", "package:///a.stl"}) {
    EXPECT_EQ(refusal(address), "'" + address + "' is incomplete; expected package://NAME/PATH");
  }
  EXPECT_EQ(refusal("file://a.stl"), "'file://a.stl' is no absolute path; expected file:///PATH");
  EXPECT_EQ(refusal("http://a/b.stl"),
            "found 'http://a/b.stl'; expected an address that starts with package:// or file://");
}

TEST_F(Addresses, aPathHasAUrl) {
  EXPECT_EQ(fileUrl("/a b/c#1/d.stl"), "file:///a%20b/c%231/d.stl");
  touch("other parts/a#1.stl");
  EXPECT_EQ(find(fileUrl((root_ / "other parts/a#1.stl").string())).path,
            (root_ / "other parts/a#1.stl").string());
}

TEST_F(Addresses, extensionsAreReadInAnyCase) {
  EXPECT_EQ(extensionOf("package://a/b.TUM"), ".tum");
  EXPECT_EQ(extensionOf("package://a/b.c/d.Stl"), ".stl");
  EXPECT_EQ(extensionOf("package://a.b/c"), "");
}

}  // namespace
}  // namespace cable_variation
