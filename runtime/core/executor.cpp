#include "runtime/executor.h"

#include <algorithm>

namespace warplut {

void SerialExecutor::Run(int count, Call call, const void* context) {
  for (int i = 0; i < count; ++i) call(context, i);
}

ThreadPool::ThreadPool(int threads) {
  if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  workers_.reserve(static_cast<std::size_t>(threads) - 1);
  for (int i = 1; i < threads; ++i) workers_.emplace_back([this] { Work(); });
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  begin_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::TakePieces(std::unique_lock<std::mutex>& lock) {
  while (next_ < count_) {
    const int piece = next_++;
    ++running_;
    lock.unlock();
    call_(context_, piece);
    lock.lock();
    --running_;
  }
}

void ThreadPool::Work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    begin_.wait(lock, [this] { return stop_ || next_ < count_; });
    if (stop_) return;
    TakePieces(lock);
    if (running_ == 0) end_.notify_one();
  }
}

void ThreadPool::Run(int count, Call call, const void* context) {
  std::unique_lock lock(mutex_);
  call_ = call;
  context_ = context;
  next_ = 0;
  count_ = count;
  if (count > 1) begin_.notify_all();
  TakePieces(lock);
  end_.wait(lock, [this] { return running_ == 0; });
  count_ = 0;
}

}  // namespace warplut
