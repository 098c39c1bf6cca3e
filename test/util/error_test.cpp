// Which kind an exception is of, our own and others.
#include <cable_variation/util/error.h>

#include <filesystem>
#include <new>
#include <system_error>

#include <gtest/gtest.h>

namespace cable_variation {
namespace {

TEST(error, tells_its_kind_and_message_whatever_it_is_caught_as) {
  EXPECT_EQ(kindOf(NotFound("no cable named 'x'")), ErrorKind::not_found);
  EXPECT_EQ(kindOf(NotConverged("x")), ErrorKind::not_converged);
  EXPECT_EQ(kindOf(Unstable("x")), ErrorKind::unstable);
  EXPECT_EQ(kindOf(Impossible("x")), ErrorKind::impossible);
  EXPECT_EQ(kindOf(FileError("x")), ErrorKind::file_error);
  EXPECT_EQ(kindOf(Cancelled()), ErrorKind::cancelled);
  EXPECT_EQ(kindOf(InternalError("x")), ErrorKind::internal);
  try {
    throw NotFound("no cable named 'x'");
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(kindOf(error), ErrorKind::not_found);
    EXPECT_STREQ(error.what(), "no cable named 'x'");
  }
}

TEST(error, of_the_standard_library_is_what_it_says_and_nothing_is_guessed) {
  EXPECT_EQ(kindOf(std::invalid_argument("x")), ErrorKind::invalid_input);
  EXPECT_EQ(kindOf(std::bad_alloc()), ErrorKind::out_of_memory);
  EXPECT_EQ(kindOf(std::filesystem::filesystem_error("x", std::make_error_code(std::errc::io_error))),
            ErrorKind::file_error);
  EXPECT_EQ(kindOf(std::logic_error("x")), ErrorKind::internal);
  EXPECT_EQ(kindOf(std::out_of_range("x")), ErrorKind::internal);
  EXPECT_EQ(kindOf(std::runtime_error("x")), ErrorKind::internal);
  EXPECT_EQ(kindOf(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again))),
            ErrorKind::internal);
  EXPECT_EQ(kindOf(std::exception()), ErrorKind::internal);
}

}  // namespace
}  // namespace cable_variation
