#include "runtime/executor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <thread>
#include <vector>

namespace warplut {
namespace {

// How often each of `count` pieces was called.
std::vector<int> Calls(Executor& executor, int count) {
  std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
  executor.ForEach(count, [&](int i) { calls[static_cast<std::size_t>(i)].fetch_add(1); });
  return {calls.begin(), calls.end()};
}

TEST(Executor, CallsEachPieceOnce) {
  SerialExecutor serial;
  EXPECT_EQ(serial.Threads(), 1);
  ThreadPool one(1), two(2), many(7);
  for (Executor* executor : std::initializer_list<Executor*>{&serial, &one, &two, &many}) {
    for (const int count : {0, 1, 2, 3, 7, 8, 1000}) {
      EXPECT_EQ(Calls(*executor, count), std::vector<int>(static_cast<std::size_t>(count), 1));
    }
  }
}

TEST(Executor, SerialRunsInOrder) {
  SerialExecutor serial;
  std::vector<int> order;
  serial.ForEach(5, [&](int i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(ThreadPool, HasTheThreadsAskedFor) {
  EXPECT_EQ(ThreadPool(1).Threads(), 1);
  EXPECT_EQ(ThreadPool(5).Threads(), 5);
  EXPECT_GE(ThreadPool(0).Threads(), 1);
  EXPECT_GE(ThreadPool(-1).Threads(), 1);
}

TEST(ThreadPool, ReturnsAfterTheLastPiece) {
  ThreadPool pool(4);
  std::atomic<int> ended = 0;
  pool.ForEach(8, [&](int i) {
    if (i % 2 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ended.fetch_add(1);
  });
  EXPECT_EQ(ended.load(), 8);
}

TEST(ThreadPool, WritesArePublished) {
  ThreadPool pool(3);
  std::vector<int> values(500);
  for (int round = 0; round < 300; ++round) {
    pool.ForEach(static_cast<int>(values.size()),
                 [&](int i) { values[static_cast<std::size_t>(i)] += i + round; });
  }
  const int rounds = 300 * 299 / 2;
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(values[static_cast<std::size_t>(i)], 300 * i + rounds);
  }
}

TEST(ThreadPool, RunsOnItsThreadsAndTheCallingOne) {
  ThreadPool pool(3);
  // Three pieces that wait for each other need three threads.
  std::atomic<int> arrived = 0;
  pool.ForEach(3, [&](int) {
    arrived.fetch_add(1);
    while (arrived.load() < 3) std::this_thread::yield();
  });
  EXPECT_EQ(arrived.load(), 3);
}

TEST(ThreadPool, EndsWithoutWork) {
  for (int i = 0; i < 50; ++i) ThreadPool pool(4);
}

}  // namespace
}  // namespace warplut
