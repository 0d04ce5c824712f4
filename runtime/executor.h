// Runs independent pieces of work: the runtime's own threads, or the job system of the engine that
// uses it.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include "luts/visibility.h"
#include "runtime/float_environment.h"

namespace WARPLUT_PUBLIC warplut {

// Every pass splits its work into pieces. Their results do not depend on thread or order, so any
// executor gives the same bits.
class Executor {
 public:
  virtual ~Executor() = default;

  // The largest number of pieces that run at the same time, at least 1.
  virtual int Threads() const = 0;

  // Calls piece(i) for i = 0 .. count - 1, in any order, on any threads; returns when all have
  // ended. `piece` must not throw and must not call ForEach. It runs in a FloatEnvironment.
  template <class Piece>
  void ForEach(int count, const Piece& piece) {
    Run(count, RunPiece<Piece>, &piece);
  }

 protected:
  using Call = void (*)(const void* context, int piece);
  virtual void Run(int count, Call call, const void* context) = 0;

 private:
  template <class Piece>
  static void RunPiece(const void* context, int i) {
    const FloatEnvironment environment;
    (*static_cast<const Piece*>(context))(i);
  }
};

// Runs pieces on the calling thread, in order.
class SerialExecutor final : public Executor {
 public:
  int Threads() const override { return 1; }

 private:
  void Run(int count, Call call, const void* context) override;
};

// Runs pieces on `threads` threads, the calling one included. One ForEach at a time.
class ThreadPool final : public Executor {
 public:
  // 0 means as many threads as the processor runs at once.
  explicit ThreadPool(int threads = 0);
  ~ThreadPool() override;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int Threads() const override { return static_cast<int>(workers_.size()) + 1; }

 private:
  void Run(int count, Call call, const void* context) override;
  void Work();
  void TakePieces(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable begin_, end_;
  Call call_ = nullptr;
  const void* context_ = nullptr;
  int next_ = 0;     // the first piece that nobody has taken
  int count_ = 0;    // pieces of this Run
  int running_ = 0;  // pieces taken and not ended
  bool stop_ = false;
  std::vector<std::thread> workers_;
};

}  // namespace warplut
