// What a client is told: a code for each kind of error, and never a guess.
#include <ros_interface/request/request_status.h>

#include <new>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <cable_variation/scene_file/scene_reader.h>
#include <cable_variation/util/error.h>
#include <ros_interface/node/spinning_thread.h>

namespace cable_variation_ros {
namespace {

using cable_variation::Status;

template <typename Thrown>
Status told(const Thrown& thrown) {
  return runRequest([&] { throw thrown; });
}

TEST(RequestStatus, SaysSuccessOnlyOfWhatThrowsNothing) {
  bool ran = false;
  const Status status = runRequest([&] { ran = true; });
  EXPECT_TRUE(ran);
  EXPECT_EQ(status.code, Status::SUCCESS);
  EXPECT_EQ(status.message, "");
}

TEST(RequestStatus, OfEachKindIsItsCodeWithTheMessageAsItWas) {
  const std::string message = "margin: is -1 m, expected above 0";
  const auto expect = [&](const Status& status, std::uint8_t code) {
    EXPECT_EQ(status.code, code);
    EXPECT_EQ(status.message, message);
  };
  expect(told(std::invalid_argument(message)), Status::INVALID_ARGUMENT);
  expect(told(cable_variation::NotFound(message)), Status::NOT_FOUND);
  expect(told(cable_variation::NotConverged(message)), Status::NOT_CONVERGED);
  expect(told(cable_variation::Impossible(message)), Status::NOT_CONVERGED);
  expect(told(cable_variation::Unstable(message)), Status::UNSTABLE);
  expect(told(cable_variation::Cancelled(message)), Status::CANCELLED);
  expect(told(cable_variation::FileError(message)), Status::IO_ERROR);
}

TEST(RequestStatus, OfNoMemorySaysSoInWords) {
  const Status status = told(std::bad_alloc());
  EXPECT_EQ(status.code, Status::OUT_OF_MEMORY);
  EXPECT_NE(status.message.find("memory"), std::string::npos) << status.message;
  using MemoryTaken = cable_variation::ErrorOf<cable_variation::ErrorKind::out_of_memory>;
  const Status busy = told(MemoryTaken("busy: runs at work: 4"));
  EXPECT_EQ(busy.code, Status::OUT_OF_MEMORY);
  EXPECT_EQ(busy.message, "busy: runs at work: 4");
}

TEST(RequestStatus, WhatARequestHasInItsNamesIsReadable) {
  const std::string names = "'\xff' '\x1b[2J' '%s%n' 'größe'";
  const std::string readable = R"('\xff' '\x1b[2J' '%s%n' 'größe')";
  EXPECT_EQ(told(cable_variation::NotFound("no variable named " + names)).message,
            "no variable named " + readable);
  const Status status =
      told(std::invalid_argument("no clip named '" + std::string(1000000, 'x') + "', expected one"));
  EXPECT_LT(status.message.size(), 3000U);
  EXPECT_EQ(status.message.rfind("no clip named 'xxx", 0), 0U);
  EXPECT_NE(status.message.find("', expected one"), std::string::npos);
}

TEST(RequestStatus, FaultsOfASceneHaveALineEach) {
  const cable_variation::SceneError error({{"scene.yaml", 3, "fault 1"}, {"scene.yaml", 4, "fault 2"}});
  EXPECT_EQ(told(error).message, error.what());
  EXPECT_NE(told(error).message.find('\n'), std::string::npos);
}

TEST(RequestStatus, OfWhatNothingIsKnownOfIsAFaultOfTheProgram) {
  for (const Status& status :
       {told(std::runtime_error("vertex 7")), told(std::logic_error("vertex 7")),
        told(std::out_of_range("vertex 7")), told(cable_variation::InternalError("vertex 7"))}) {
    EXPECT_EQ(status.code, Status::INTERNAL_ERROR);
    EXPECT_NE(status.message.find("fault of this program"), std::string::npos) << status.message;
    EXPECT_NE(status.message.find("vertex 7"), std::string::npos) << status.message;
  }
}

TEST(RequestStatus, OfANodeThatEndsIsCancelled) { EXPECT_EQ(told(NodeEnds()).code, Status::CANCELLED); }

}  // namespace
}  // namespace cable_variation_ros
