// Processor time of what the runtime does, apart from its caller's.
#pragma once

#include "runtime/executor.h"
#include "tools/bench/timing.h"

namespace warplut {

// Runs pieces on the calling thread and adds up the processor time that they take.
class TimedExecutor final : public Executor {
 public:
  int Threads() const override { return 1; }
  double milliseconds() const { return milliseconds_; }

 private:
  void Run(int count, Call call, const void* context) override {
    milliseconds_ += Milliseconds([&] {
      for (int i = 0; i < count; ++i) call(context, i);
    });
  }

  double milliseconds_ = 0;
};

}  // namespace warplut
