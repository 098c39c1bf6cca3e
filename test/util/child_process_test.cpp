// Programs that end well, end badly, do not end, or say too much: the one that runs them lives on and tells.
#include <cable_variation/util/child_process.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include <cable_variation/util/error.h>

namespace cable_variation {
namespace {

constexpr std::size_t kMost = 1 << 20;

ChildRun shell(const std::string& script, const std::string& input = "", double seconds = 30.0,
               std::size_t most = kMost) {
  return runChild("/bin/sh", {"-c", script}, input, seconds, most);
}

TEST(ChildProcess, HandsOverInputAndOutputAsTheyAre) {
  std::string bytes;
  for (unsigned i = 0; i < 300000U; ++i) bytes += static_cast<char>(i * 7919U >> 3U);
  const ChildRun run = shell("cat", bytes);
  EXPECT_EQ(run.end, ChildRun::End::exited);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.output, bytes);
  EXPECT_EQ(shell("cat").output, "");
}

TEST(ChildProcess, TellsHowItEnded) {
  for (const int code : {0, 1, 2, 3, 42}) {
    const ChildRun run = shell("exit " + std::to_string(code));
    EXPECT_EQ(run.end, ChildRun::End::exited);
    EXPECT_EQ(run.code, code);
  }
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGKILL, SIGXCPU}) {
    const ChildRun run = shell("printf before; kill -" + std::to_string(signal) + " $$");
    EXPECT_EQ(run.end, ChildRun::End::killed_by_signal) << signal;
    EXPECT_EQ(run.code, signal);
    EXPECT_EQ(run.output, "before");
  }
  EXPECT_EQ(signalName(SIGSEGV), "Segmentation fault");
}

// Also one that has closed its output and goes on.
TEST(ChildProcess, EndsWhatDoesNotEnd) {
  for (const char* script : {"sleep 100", "exec sleep 100", "exec sleep 100 >&-", "while :; do :; done"}) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(shell(script, "", 0.3).end, ChildRun::End::took_too_long) << script;
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30)) << script;
  }
  EXPECT_EQ(shell("yes", "", 30.0, 100000).end, ChildRun::End::wrote_too_much);
}

// Signals that this process ignores or holds back are the program's own to take.
TEST(ChildProcess, HasSignalsOfItsOwn) {
  const auto usual = std::signal(SIGTERM, SIG_IGN);
  sigset_t held, before;
  sigemptyset(&held);
  sigaddset(&held, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &held, &before);
  const ChildRun run = shell("kill -TERM $$; exec sleep 100", "", 20.0);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  std::signal(SIGTERM, usual);
  EXPECT_EQ(run.end, ChildRun::End::killed_by_signal);
  EXPECT_EQ(run.code, SIGTERM);
}

TEST(ChildProcess, OfSeveralThreadsDoNotDisturbEachOther) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    threads.emplace_back([&, i] {
      for (int round = 0; round < 10; ++round) {
        const std::string text(10000 + i, static_cast<char>('a' + i));
        const ChildRun run = shell("cat; exit " + std::to_string(i), text);
        if (run.output != text || run.code != static_cast<int>(i)) ++wrong[i];
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST(ChildProcess, ThatIsNotThereIsNamed) {
  try {
    runChild("/no/such/program", {}, "", 1.0, kMost);
    ADD_FAILURE() << "it ran";
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()),
              "the program '/no/such/program' cannot be run: No such file or directory");
  }
}

}  // namespace
}  // namespace cable_variation
