// What is no file is refused at once, by its kind; what is one is read whole, or line by line.
#include <cable_variation/util/regular_file.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <cable_variation/util/data_lines.h>

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

class RegularFileTest : public testing::Test {
 protected:
  RegularFileTest() {
    std::string name = (fs::temp_directory_path() / "regular_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~RegularFileTest() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& contents) const {
    std::ofstream(folder_ / name, std::ios::binary) << contents;
    return folder_ / name;
  }
  std::string refusal(const std::string& path, std::uintmax_t most = kAnySize,
                      RegularFile::Links links = RegularFile::Links::follow) const {
    try {
      readWhole(path, most, links);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(RegularFileTest, WhatIsNoneIsToldByItsKindAtOnce) {
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  (folder_ / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  fs::create_symlink(folder_ / "pipe", folder_ / "to_pipe");
  fs::create_symlink(folder_ / "nothing", folder_ / "to_nothing");
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_EQ(refusal(folder_ / "pipe"), "is a named pipe; expected a file");
  EXPECT_EQ(refusal(folder_ / "to_pipe"), "is a named pipe; expected a file");
  EXPECT_EQ(refusal(folder_ / "socket"), "is a socket; expected a file");
  EXPECT_EQ(refusal(folder_), "is a folder; expected a file");
  EXPECT_EQ(refusal("/dev/zero"), "is a device; expected a file");
  EXPECT_EQ(refusal("/dev/tty"), "is a device; expected a file");
  EXPECT_EQ(refusal(folder_ / "to_nothing"), "does not exist");
  EXPECT_EQ(refusal(folder_ / "circle"), "does not exist");
  EXPECT_EQ(refusal(""), "does not exist");
  EXPECT_EQ(refusal(std::string("/etc/passwd\0.stl", 16)), "has a byte 0 in its name; expected a file");
  close(socket);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST_F(RegularFileTest, LinksAreFollowedOrRefused) {
  const std::string file = write("file", "contents");
  fs::create_symlink(file, folder_ / "link");
  EXPECT_EQ(readWhole(folder_ / "link", 100), "contents");
  EXPECT_EQ(readWhole(file, 100, RegularFile::Links::refuse), "contents");
  EXPECT_EQ(refusal(folder_ / "link", 100, RegularFile::Links::refuse), "is a link; expected a file");
}

TEST_F(RegularFileTest, OfAnySizeUpToTheLimitIsReadWhole) {
  for (const std::size_t size : {0U, 1U, 65535U, 65536U, 65537U, 300000U}) {
    std::string contents(size, '\0');
    std::mt19937 random(static_cast<unsigned>(size));
    for (char& c : contents) c = static_cast<char>(random());
    const std::string path = write("file", contents);
    EXPECT_EQ(readWhole(path, size), contents);
    if (size > 0) {
      EXPECT_NE(refusal(path, size - 1).find("; expected at most "), std::string::npos);
    }
  }
  // files of the system have no size beforehand
  EXPECT_NE(readWhole("/proc/self/status", 100000), "");
  EXPECT_EQ(refusal("/proc/self/status", 10), "grows while it is read");
}

std::vector<std::string> linesOf(const std::string& path, std::uintmax_t most = kAnySize) {
  std::vector<std::string> lines;
  readDataLines(path, most, [&](const std::string& line) { lines.push_back(line); });
  return lines;
}

using DataLines = RegularFileTest;

TEST_F(DataLines, AreThoseBetweenCommentsAndBlanks) {
  const std::string path = write("a",
                                 "\xef\xbb\xbf"
                                 "1 2 # first\n\n# nothing\n \t\r\n3\r\n4#\n#\n5");
  EXPECT_EQ(linesOf(path), (std::vector<std::string>{"1 2 ", "3\r", "4", "5"}));
  EXPECT_EQ(linesOf(write("b", "")), std::vector<std::string>());
  EXPECT_EQ(linesOf(write("c", "\n")), std::vector<std::string>());
}

// However the file is cut into the pieces that are read.
TEST_F(DataLines, OfRandomLengths) {
  std::mt19937 random(3);
  for (int round = 0; round < 5; ++round) {
    std::vector<std::string> lines;
    std::string text;
    while (text.size() < 400000) {
      lines.emplace_back(1 + random() % (round == 0 ? 3 : 9000), static_cast<char>('a' + random() % 26));
      text += lines.back() + "\n";
    }
    if (round % 2 == 1) text.pop_back();
    EXPECT_EQ(linesOf(write("lines", text)), lines);
  }
}

TEST_F(DataLines, FaultsHaveFileAndLine) {
  const auto said = [&](const std::string& text) {
    const std::string path = write("data", text);
    try {
      readDataLines(path, 1000000, [](const std::string& line) {
        if (line == "bad") throw std::invalid_argument("it is bad");
      });
    } catch (const std::invalid_argument& error) {
      return std::string(error.what()).substr(path.size());
    }
    return std::string();
  };
  EXPECT_EQ(said("good\n\nbad\n"), ":3: it is bad");
  EXPECT_EQ(said("\xff\xfe"
                 "b\n"),
            ":1: the file is in UTF-16; expected UTF-8");
  EXPECT_EQ(said("a\n" + std::string(20000, 'x')),
            ":2: the line has more than 10000 characters; expected lines that end");
  EXPECT_NE(said(std::string(2000000, '\n')).find(": has 2 MB; expected at most 1 MB"), std::string::npos);
}

// A gigabyte without a line's end takes no memory and no time.
TEST_F(DataLines, AFileWithoutALineEndIsNotRead) {
  const std::string path = write("endless", "");
  fs::resize_file(path, 1000000000);  // no blocks on the disk
  rusage before, after;
  getrusage(RUSAGE_SELF, &before);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(linesOf(path), std::invalid_argument);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 20000);  // [kB]
}

}  // namespace
}  // namespace cable_variation
