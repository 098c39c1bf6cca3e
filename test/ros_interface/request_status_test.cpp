// What a client is told: a code for each kind of error, and never a guess.
#include <ros_interface/request/request_status.h>

#include <new>

#include <gtest/gtest.h>

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
