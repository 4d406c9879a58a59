// Whatever a worker does to itself is the end of its request alone.
#include "files/worker_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <new>
#include <thread>
#include <vector>

#include "files/byte_message.h"
#include "files/error.h"
#include "files/fallible_work.h"

namespace prairie {
namespace {

/// What a fault of a decoder is like, by name.
void misbehave(std::span<const std::byte> request, const MessageSink& reply) {
  const std::string what = MessageReader(request).text();
  if (what == "crash") raise(SIGSEGV);
  if (what == "abort") std::abort();
  if (what == "leave") _exit(7);
  if (what == "hang") {
    for (volatile bool is_hanging = true; is_hanging;) {
    }
  }
  if (what == "sleep") std::this_thread::sleep_for(std::chrono::seconds(100));
  if (what == "swell") {
    std::vector<std::vector<char>> memory;
    while (true) memory.emplace_back(std::size_t{1} << 24, 'x');
  }
  if (what == "bad input") throw BadInput("a.tif", "height.file", "nonsense", "sense");
  if (what == "break off") {
    reply(MessageWriter().put(std::string_view("half")).bytes());
    raise(SIGKILL);
  }
  if (what == "trickle") {
    while (true) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      reply({});
    }
  }
  reply(MessageWriter().put(std::string_view(what)).bytes());
}

class WorkerProcessTest : public ::testing::Test {
 protected:
  /// The replies to a request, or the message of the BadInput that came instead.
  std::vector<std::string> replies(const std::string& what) {
    std::vector<std::string> texts;
    try {
      run_fallible(worker_, MessageWriter().put(std::string_view(what)).bytes(), limits_,
                   {"x.png", "maps.color.file"},
                   [&](std::span<const std::byte> bytes) { texts.push_back(MessageReader(bytes).text()); });
    } catch (const BadInput& error) {
      texts.emplace_back(error.what());
    }
    return texts;
  }

  WorkLimits limits_{.memory_bytes = 64 << 20, .cpu_s = 1.0, .cpu_s_per_MB = 0.1, .waiting_s = 1.5};
  WorkerProcess worker_{fallible(misbehave)};
};

TEST_F(WorkerProcessTest, Replies) {
  EXPECT_EQ(replies("ping"), std::vector<std::string>{"ping"});
  EXPECT_EQ(replies(""), std::vector<std::string>{""});
}

TEST_F(WorkerProcessTest, CarriesMessagesOfAnyLength) {
  const std::string text(1'000'000, 'y');
  EXPECT_EQ(replies(text), std::vector<std::string>{text});
}

TEST_F(WorkerProcessTest, OutlivesWhateverRequestsDo) {
  for (const char* what : {"crash", "abort", "leave", "hang", "sleep", "break off", "trickle"}) {
    const std::vector<std::string> told = replies(what);
    ASSERT_FALSE(told.empty()) << what;
    EXPECT_TRUE(told.back().starts_with("x.png: maps.color.file: found a file that ")) << told.back();
    EXPECT_EQ(replies("still there"), std::vector<std::string>{"still there"}) << "after " << what;
  }
}

TEST_F(WorkerProcessTest, SaysHowARequestEnded) {
  EXPECT_NE(replies("break off").back().find("Killed"), std::string::npos);
  EXPECT_NE(replies("hang").back().find("too long"), std::string::npos);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(WorkerProcessTest, LimitsMemory) {
  EXPECT_NE(replies("swell").back().find("memory"), std::string::npos);
  EXPECT_EQ(replies("still there"), std::vector<std::string>{"still there"});
}
#endif

TEST_F(WorkerProcessTest, HandsOnFaultsOfTheInput) {
  EXPECT_EQ(replies("bad input").back(), "a.tif: height.file: found nonsense, expected sense");
}

TEST_F(WorkerProcessTest, EndsARequestThatIsNoLongerWanted) {
  struct Enough {};
  const auto start = std::chrono::steady_clock::now();
  limits_.cpu_s = limits_.waiting_s = 60.0;
  EXPECT_THROW(worker_.run(MessageWriter().put(std::string_view("trickle")).bytes(), limits_,
                           [](std::span<const std::byte>) { throw Enough{}; }),
               Enough);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(replies("still there"), std::vector<std::string>{"still there"});
}

TEST(WorkerProcess, IsServedOneAfterTheOtherFromManyThreads) {
  WorkerProcess worker{fallible(misbehave)};
  std::vector<std::thread> threads;
  std::vector<int> counts(4, 0);
  for (std::size_t t = 0; t < counts.size(); ++t) {
    threads.emplace_back([&, t] {
      for (int k = 0; k < 20; ++k) {
        const std::string text = std::string(1000 * t, 'z') + std::to_string(k);
        run_fallible(worker, MessageWriter().put(std::string_view(text)).bytes(), {.memory_bytes = 1 << 24},
                     {}, [&](std::span<const std::byte> bytes) {
                       if (MessageReader(bytes).text() == text) ++counts[t];
                     });
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(counts, std::vector<int>(4, 20));
}

TEST(WorkerProcess, ReportsAProgramThatIsNotThere) {
  EXPECT_THROW(WorkerProcess("/nowhere/prairie", "decode"), BadInput);
}

/// Waits for the end of a process; false if it takes too long.
bool ends(pid_t process) {
  for (int k = 0; k < 200; ++k) {
    if (kill(process, 0) != 0) return true;
    // A zombie whose new parent does not wait counts as ended.
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    std::string id, name, state;
    if (!(stat >> id >> name >> state) || state == "Z") return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
  }
  return false;
}

TEST(WorkerProcess, EndsWithTheProcessThatAsked) {
  int ends_of_pipe[2];
  ASSERT_EQ(pipe(ends_of_pipe), 0);
  const pid_t asker = fork();
  if (asker == 0) {
    const auto tell_and_hang = [&](std::span<const std::byte>, const MessageSink&) {
      const pid_t self = getpid();
      if (write(ends_of_pipe[1], &self, sizeof self) != sizeof self) _exit(1);
      std::this_thread::sleep_for(std::chrono::seconds(100));
    };
    WorkerProcess worker{tell_and_hang};
    worker.run({}, {.memory_bytes = 1 << 24}, [](std::span<const std::byte>) {});
    _exit(0);
  }
  pid_t worker = 0;
  ASSERT_EQ(read(ends_of_pipe[0], &worker, sizeof worker), static_cast<ssize_t>(sizeof worker));
  EXPECT_EQ(kill(worker, 0), 0);
  kill(asker, SIGKILL);
  int status = 0;
  waitpid(asker, &status, 0);
  EXPECT_TRUE(ends(worker));
  close(ends_of_pipe[0]);
  close(ends_of_pipe[1]);
}

}  // namespace
}  // namespace prairie
