// Files that are there complete or not at all, whoever else writes them, and whatever the disk says.
#include <cable_variation/util/output_file.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

#include <small_files.h>

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

std::string contentsOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest() {
    std::string name = (fs::temp_directory_path() / "output_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~OutputFileTest() override { fs::remove_all(folder_); }

  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.insert(entry.path().filename());
    return names;
  }

  fs::path folder_;
};

std::string failureOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

// Of `size` characters, all the same: a mixture of two shows.
std::string letters(std::size_t writer, std::size_t size) {
  return std::string(size + writer, static_cast<char>('a' + writer));
}

bool isOneOf(const std::string& contents, std::size_t writers, std::size_t size) {
  for (std::size_t i = 0; i < writers; ++i) {
    if (contents == letters(i, size)) return true;
  }
  return false;
}

TEST_F(OutputFileTest, ThreadsAndProcessesThatWriteTheSamePathLeaveAWholeFileOfOneOfThem) {
  constexpr std::size_t kProcesses = 3, kThreads = 3, kRounds = 25, kSize = 200000;
  const std::string path = folder_ / "report.html";
  writeFile(path, letters(0, kSize));
  std::vector<pid_t> children;
  for (std::size_t process = 0; process < kProcesses; ++process) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      int failed = 0;
      std::vector<std::thread> threads;
      std::vector<int> failures(kThreads, 0);
      for (std::size_t thread = 0; thread < kThreads; ++thread) {
        threads.emplace_back([&, thread] {
          for (std::size_t round = 0; round < kRounds; ++round) {
            try {
              writeFile(path, letters(process * kThreads + thread, kSize));
            } catch (const std::exception&) {
              ++failures[thread];
            }
          }
        });
      }
      for (std::thread& thread : threads) thread.join();
      for (const int failure : failures) failed += failure;
      _exit(std::min(failed, 100));
    }
    children.push_back(child);
  }
  std::size_t looks = 0, mixtures = 0, running = children.size();
  while (running > 0) {
    ++looks;
    if (!isOneOf(contentsOf(path), kProcesses * kThreads, kSize)) ++mixtures;
    int status = 0;
    while (running > 0 && waitpid(-1, &status, WNOHANG) > 0) {
      --running;
      EXPECT_TRUE(WIFEXITED(status));
      EXPECT_EQ(WEXITSTATUS(status), 0) << "writes that failed";
    }
  }
  EXPECT_GT(looks, 2u);
  EXPECT_EQ(mixtures, 0u) << "of " << looks;
  EXPECT_TRUE(isOneOf(contentsOf(path), kProcesses * kThreads, kSize));
  EXPECT_EQ(names(), (std::set<std::string>{"report.html"})) << "nothing temporary is left";
}

TEST_F(OutputFileTest, StagedFilesTakeTheirNamesTogetherOrGo) {
  const std::string path = folder_ / "a.stl";
  writeFile(path, "old");
  {
    const StagedFile dropped(path, "new");
    EXPECT_EQ(contentsOf(path), "old");
    EXPECT_EQ(names().size(), 2u);
  }
  EXPECT_EQ(contentsOf(path), "old");
  EXPECT_EQ(names(), (std::set<std::string>{"a.stl"}));
  std::vector<StagedFile> staged;
  for (const char* name : {"a.stl", "b.stl", "c.stl"}) staged.emplace_back(folder_ / name, name);
  EXPECT_EQ(contentsOf(path), "old");
  StagedFile::commit(staged);
  EXPECT_EQ(names(), (std::set<std::string>{"a.stl", "b.stl", "c.stl"}));
  EXPECT_EQ(contentsOf(path), "a.stl");
}

TEST_F(OutputFileTest, OthersMayReadWhatTheProcessLetsThem) {
  const mode_t usual = umask(027);
  writeFile(folder_ / "report", "");
  umask(usual);
  struct stat found;
  ASSERT_EQ(stat((folder_ / "report").c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777, 0640u);
}

TEST_F(OutputFileTest, AFolderThatIsNotThereIsNamed) {
  EXPECT_NE(failureOf([&] {
              writeFile(folder_ / "no" / "report.html", "x");
            }).find("no/report.html' cannot be written: No such file"),
            std::string::npos);
  writeFile(folder_ / "file", "x");
  EXPECT_NE(failureOf([&] {
              writeFile(folder_ / "file" / "report.html", "x");
            }).find("file/report.html' cannot be written: Not a directory"),
            std::string::npos);
  fs::create_directory(folder_ / "taken");
  EXPECT_NE(failureOf([&] { writeFile(folder_ / "taken", "x"); }).find("taken' cannot be written"),
            std::string::npos);
  EXPECT_EQ(names(), (std::set<std::string>{"file", "taken"}));
}

// What stands in the file's place is replaced, not opened: a link leads nowhere, nobody waits for a pipe.
TEST_F(OutputFileTest, LinksAndPipesInItsPlaceAreReplaced) {
  const fs::path outside = folder_ / "outside";
  fs::create_directories(outside);
  std::ofstream(outside / "kept") << "kept";
  const fs::path out = folder_ / "out";
  fs::create_directories(out);
  fs::create_symlink(outside / "kept", out / "link");
  fs::create_symlink(outside / "new", out / "to_nothing");
  fs::create_symlink(outside, out / "to_folder");
  ASSERT_EQ(mkfifo((out / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "to_nothing", "to_folder", "pipe"}) {
    writeFile(out / name, "written");
    EXPECT_EQ(fs::symlink_status(out / name).type(), fs::file_type::regular) << name;
    EXPECT_EQ(contentsOf(out / name), "written") << name;
  }
  EXPECT_EQ(contentsOf(outside / "kept"), "kept");
  EXPECT_EQ(std::distance(fs::directory_iterator(outside), {}), 1);
}

TEST_F(OutputFileTest, ADiskThatFillsLeavesTheOldFileAndNothingElse) {
  const std::string path = folder_ / "report.html";
  writeFile(path, "old");
  const std::string said = failureOf([&] {
    const SmallFiles small;
    writeFile(path, std::string(100000, 'x'));
  });
  EXPECT_EQ(said, "file '" + path + "' cannot be written: File too large");
  EXPECT_EQ(contentsOf(path), "old");
  EXPECT_EQ(names(), (std::set<std::string>{"report.html"}));
}

}  // namespace
}  // namespace cable_variation
