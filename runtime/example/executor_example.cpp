// Runs super resolution on the jobs of an engine, here std::async: the same bits as on one thread.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <future>
#include <vector>

#include "luts/baked/warplut_iir_x2.h"
#include "runtime/executor.h"
#include "runtime/image_buffer.h"
#include "runtime/super_resolution.h"
#include "scene.h"

namespace {

using namespace warplut;

class Jobs final : public Executor {
 public:
  explicit Jobs(int threads) : threads_(threads) {}
  int Threads() const override { return threads_; }

 private:
  // At most Threads() pieces run at a time, in any order. All have ended when Run returns.
  void Run(int count, Call call, const void* context) override {
    std::atomic<int> next = 0;
    const auto work = [&] {
      for (int piece; (piece = next++) < count;) call(context, piece);
    };
    std::vector<std::future<void>> jobs;
    for (int i = 1; i < std::min(threads_, count); ++i) {
      jobs.push_back(std::async(std::launch::async, work));
    }
    work();
    for (const std::future<void>& job : jobs) job.wait();
  }

  int threads_;
};

ImageBuffer Upscale(Executor& executor) {
  constexpr int kWidth = 320, kHeight = 180;
  const Table table(baked::kWarplutIirX2);
  SuperResolutionOptions options;
  options.render_width = kWidth / 2;
  options.render_height = kHeight / 2;
  options.output_width = kWidth;
  options.output_height = kHeight;
  options.warp = {.filter = Filter::kLut, .table = &table};
  SuperResolution super_resolution(options, executor);
  example::Scene scene(kWidth / 2, kHeight / 2, kWidth, kHeight);
  ImageBuffer shown(kWidth, kHeight, PixelFormat::kRgba8);
  for (int i = 0; i < 8; ++i) super_resolution.Process(scene.Render(i), shown);
  return shown;
}

}  // namespace

int main() {
  Jobs jobs(3);
  SerialExecutor serial;
  const ImageBuffer a = Upscale(jobs), b = Upscale(serial);
  const bool same = std::memcmp(a.view().data, b.view().data, a.bytes()) == 0;
  std::printf("on 3 jobs and on one thread: %s\n", same ? "the same bits" : "other bits");
  return same ? 0 : 1;
}
