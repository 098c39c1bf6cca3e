// Samples written as they come: complete, or marked as partial; a disk that fills is an error.
#include <cable_variation/report/sample_csv.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include <sys/resource.h>
#include <sys/stat.h>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

#include <small_files.h>

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

class SampleCsvTest : public testing::Test {
 protected:
  SampleCsvTest() {
    std::string name = (fs::temp_directory_path() / "samples_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    path_ = (folder_ / "samples.csv").string();
    DesignVariable length;
    length.name = "length";
    length.unit = "m";
    length.nominal = 0.3;
    scene_.design_variables = {length};
    Measure gap;
    gap.name = "a \"gap\"";
    gap.unit = "m";
    scene_.measures = {gap, gap};
  }
  ~SampleCsvTest() override { fs::remove_all(folder_); }

  SampleCsv csv() const { return SampleCsv(path_, scene_, {0}, {1}, {}); }

  static std::string contentsOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  fs::path folder_;
  std::string path_;
  Scene scene_;
};

TEST_F(SampleCsvTest, ACompleteFileHasItsName) {
  SampleCsv samples = csv();
  const double deviation = 0.0625, value = 0.1;
  samples.add(0, SampleOutcome::solved, &deviation, &value);
  samples.add(1, SampleOutcome::not_converged, &deviation, nullptr);
  EXPECT_FALSE(fs::exists(path_));
  samples.finish();
  EXPECT_FALSE(fs::exists(samples.partialPath()));
  EXPECT_EQ(contentsOf(path_),
            "sample,outcome,\"length [m]\",\"a \"\"gap\"\" [m]\"\r\n"
            "0,solved,0.3625,0.1\r\n"
            "1,not_converged,0.3625,nan\r\n");
  EXPECT_THROW(samples.add(2, SampleOutcome::solved, &deviation, &value), std::logic_error);
}

TEST_F(SampleCsvTest, AnEndedOneIsMarkedAsPartial) {
  const double zero = 0.0;
  {
    SampleCsv samples = csv();
    samples.add(0, SampleOutcome::solved, &zero, &zero);
  }
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_NE(contentsOf(path_ + ".partial").find("0,solved,"), std::string::npos);
}

TEST_F(SampleCsvTest, AnEndedOneIsOnTheDiskOrAnError) {
  const double zero = 0.0;
  SampleCsv ended = csv();
  ended.add(0, SampleOutcome::solved, &zero, &zero);
  ended.stop();
  EXPECT_NE(contentsOf(path_ + ".partial").find("0,solved,"), std::string::npos);
  EXPECT_THROW(ended.add(1, SampleOutcome::solved, &zero, &zero), std::logic_error);

  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit few{10, old.rlim_max};  // [B]
  SampleCsv full = csv();
  full.add(0, SampleOutcome::solved, &zero, &zero);  // not more than fits into the buffer
  setrlimit(RLIMIT_FSIZE, &few);
  std::string said;
  try {
    full.stop();
  } catch (const FileError& error) {
    said = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, before);
  EXPECT_NE(said.find(std::strerror(EFBIG)), std::string::npos) << said;
}

// What stands in the file's place is replaced, not opened: a link leads nowhere, nobody waits for a pipe.
TEST_F(SampleCsvTest, LinksAndPipesInItsPlaceAreReplaced) {
  const double zero = 0.0;
  const fs::path elsewhere = folder_ / "elsewhere";
  std::ofstream(elsewhere) << "kept";
  fs::create_symlink(elsewhere, path_ + ".partial");
  for (int i = 0; i < 2; ++i) {
    SampleCsv samples = csv();
    samples.add(0, SampleOutcome::solved, &zero, &zero);
    samples.finish();
    EXPECT_EQ(fs::symlink_status(path_).type(), fs::file_type::regular);
    EXPECT_NE(contentsOf(path_).find("0,solved,"), std::string::npos);
    ASSERT_EQ(mkfifo((path_ + ".partial").c_str(), 0600), 0);
  }
  EXPECT_EQ(contentsOf(elsewhere.string()), "kept");
}

TEST_F(SampleCsvTest, AFolderThatIsNotThereIsAnError) {
  try {
    SampleCsv((folder_ / "no" / "samples.csv").string(), scene_, {0}, {1}, {});
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("samples.csv.partial' cannot be written: No such file"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(SampleCsvTest, AFolderInItsPlaceIsNamed) {
  fs::create_directories(path_);
  SampleCsv samples = csv();
  try {
    samples.finish();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("samples.csv' cannot be written: Is a directory"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(SampleCsvTest, ARunKeepsItsFileWhileItWrites) {
  const double zero = 0.0;
  SampleCsv first = csv();
  first.add(0, SampleOutcome::solved, &zero, &zero);
  // a lock is of the open file: another run of this process is kept out as one of another process is
  try {
    csv();
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("another run writes it now"), std::string::npos) << error.what();
  }
  first.add(1, SampleOutcome::solved, &zero, &zero);
  first.finish();
  const std::string complete = contentsOf(path_);
  EXPECT_NE(complete.find("\r\n1,solved,"), std::string::npos) << complete;
  SampleCsv next = csv();  // what an earlier run left is replaced, the complete file stays until then
  next.stop();
  EXPECT_EQ(contentsOf(path_), complete);
  SampleCsv last = csv();
  last.finish();
  EXPECT_EQ(contentsOf(path_).find("solved"), std::string::npos);
}

TEST_F(SampleCsvTest, ADiskThatFillsIsAnError) {
  SampleCsv samples = csv();
  std::string said;
  std::uint64_t written = 0;
  try {
    const SmallFiles small;
    for (; written < 10000; ++written) {
      const double value = 1.0 / 3.0;
      samples.add(written, SampleOutcome::solved, &value, &value);
    }
  } catch (const FileError& error) {
    said = error.what();
  }
  EXPECT_LT(written, 10000u);
  EXPECT_NE(said.find("cannot be written: File too large"), std::string::npos) << said;
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_TRUE(fs::exists(samples.partialPath()));
}

}  // namespace
}  // namespace cable_variation
