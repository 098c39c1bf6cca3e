// Files are written below one folder, whatever name is asked for.
#include <cable_variation/analysis/output_directory.h>

#include <filesystem>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

#include "test_packages.h"

namespace cable_variation {
namespace {

namespace fs = std::filesystem;

/// A path that does not exist, gone with all below it at the end.
class FreshPath : public testing::Test {
 protected:
  ~FreshPath() override { fs::remove_all(path_); }
  fs::path path_ = fs::temp_directory_path() / (std::to_string(getpid()) + "_output");
};

using OutputDirectoryTest = FreshPath;

TEST_F(OutputDirectoryTest, IsMadeWhenAFileIsToBeWritten) {
  const OutputDirectory output((path_ / "a" / "b").string());
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_EQ(output.fileFor("run_3.final-2", ".csv"), (path_ / "a" / "b" / "run_3.final-2.csv").string());
  EXPECT_TRUE(fs::is_directory(path_ / "a" / "b"));
}

TEST_F(OutputDirectoryTest, NamesThatLeadElsewhereAreRefused) {
  const OutputDirectory output(path_.string());
  for (const std::string& name :
       {std::string("../x"), std::string("/tmp/x"), std::string("a/b"), std::string(".."), std::string(".x"),
        std::string(), std::string("a\\b"), std::string("a b"), std::string("ä"), std::string(101, 'a')}) {
    try {
      output.fileFor(name, ".csv");
      ADD_FAILURE() << "'" << name << "' was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("'" + name + "'"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(output.fileFor(std::string("a\0b", 3), ".csv"), std::invalid_argument);
  EXPECT_FALSE(fs::exists(path_));
  EXPECT_NO_THROW(OutputDirectory::checkName(std::string(100, 'a')));
}

TEST_F(OutputDirectoryTest, WhetherFilesCanBeWrittenIsToldWithoutATrace) {
  EXPECT_NO_THROW(OutputDirectory((path_ / "a" / "b").string()).requireWritable());
  EXPECT_FALSE(fs::exists(path_));
  fs::create_directory(path_);
  EXPECT_NO_THROW(OutputDirectory(path_.string()).requireWritable());
  EXPECT_TRUE(fs::is_empty(path_));
  const TemporaryFile file("in_the_way", {});
  for (const std::string& folder : {file.path(), file.path() + "/below", file.path() + "/below/that"}) {
    try {
      OutputDirectory(folder).requireWritable();
      ADD_FAILURE() << folder;
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("'" + folder + "'"), std::string::npos) << error.what();
    }
  }
}

TEST_F(OutputDirectoryTest, AFolderThatCannotBeMadeIsNamed) {
  const TemporaryFile file("in_the_way", {});
  try {
    OutputDirectory(file.path() + "/below").fileFor("x", ".csv");
    ADD_FAILURE() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(file.path() + "/below"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cable_variation
