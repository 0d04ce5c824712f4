// Ranks of MPI.
#include <mpi.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <thread>

#include "datasets/error.h"
#include "train/ranks/launch.h"
#include "train/ranks/ranks.h"

namespace warplut {
namespace {

// All counts of MPI are ints: longer messages go in parts.
constexpr std::size_t kLongestMessage = std::size_t{1} << 26;

const Ranks* started = nullptr;

// What exchanges of this rank took, for tools/measure/measure_ranks.sh.
struct ExchangeTimes {
  int calls = 0;
  double bytes = 0;      // received and sent
  double processor = 0;  // seconds; waits count, as MPI waits busily
  double quickest = 0;   // seconds of wall time
} exchange_times;

double ProcessorSeconds() {
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Counts one exchange while it lives.
class CountedExchange {
 public:
  ~CountedExchange() {
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    exchange_times.processor += ProcessorSeconds() - processor_;
    exchange_times.quickest =
        exchange_times.calls == 0 ? seconds : std::min(exchange_times.quickest, seconds);
    ++exchange_times.calls;
  }

 private:
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  const double processor_ = ProcessorSeconds();
};

void Broadcast(double* values, std::size_t count, int root) {
  for (std::size_t at = 0; at < count; at += kLongestMessage) {
    const auto part = static_cast<int>(std::min(kLongestMessage, count - at));
    MPI_Bcast(values + at, part, MPI_DOUBLE, root, MPI_COMM_WORLD);
  }
}

}  // namespace

Ranks::Ranks() {
  if (LaunchedRanks() == 0) return;
  int provided = 0;
  // Only the main thread calls MPI. Its default handler of errors ends all ranks.
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

Ranks::~Ranks() {
  if (std::getenv("WARPLUT_RANK_TIMES") != nullptr) {
    const ExchangeTimes& times = exchange_times;
    std::fprintf(stderr,
                 "rank %d: %.3f s of processor time without exchanges, %d exchanges, %.0f bytes, "
                 "quickest %.6f s\n",
                 rank_, ProcessorSeconds() - times.processor, times.calls, times.bytes,
                 times.quickest);
  }
  int started = 0;
  MPI_Initialized(&started);
  if (started != 0) MPI_Finalize();
}

Ranks& Ranks::World() {
  static Ranks world;
  started = &world;
  return world;
}

const Ranks* Ranks::Started() { return started; }

void Ranks::Meet() {
  if (count_ > 1) MPI_Barrier(MPI_COMM_WORLD);
}

void Ranks::WaitForRoot() {
  if (count_ == 1) return;
  constexpr auto kPause = std::chrono::milliseconds(5);
  char here = 0;
  MPI_Request request;
  MPI_Ibcast(&here, 1, MPI_CHAR, 0, MPI_COMM_WORLD, &request);
  for (int done = 0;;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done != 0) return;
    std::this_thread::sleep_for(kPause);
  }
}

bool Ranks::Any(bool here) {
  if (count_ == 1) return here;
  int mine = here ? 1 : 0, any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return any != 0;
}

double Ranks::OfRoot(double value) {
  if (count_ > 1) Broadcast(&value, 1, 0);
  return value;
}

void Ranks::Exchange(std::span<const int> owners, std::vector<std::vector<double>>& items) {
  if (count_ == 1) return;
  const CountedExchange counted;
  // Lengths first: an owner knows its own, the others are 0 here.
  std::vector<std::int64_t> lengths(items.size(), 0);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (owners[i] == rank_) lengths[i] = static_cast<std::int64_t>(items[i].size());
  }
  MPI_Allreduce(MPI_IN_PLACE, lengths.data(), static_cast<int>(lengths.size()), MPI_INT64_T,
                MPI_SUM, MPI_COMM_WORLD);
  std::vector<double> packed;
  for (int owner = 0; owner < count_; ++owner) {
    packed.clear();
    std::size_t total = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (owners[i] != owner) continue;
      total += static_cast<std::size_t>(lengths[i]);
      if (owner == rank_) packed.insert(packed.end(), items[i].begin(), items[i].end());
    }
    packed.resize(total);
    exchange_times.bytes += static_cast<double>(total * sizeof(double));
    Broadcast(packed.data(), total, owner);
    if (owner == rank_) continue;
    auto next = packed.cbegin();
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (owners[i] != owner) continue;
      items[i].assign(next, next + lengths[i]);
      next += lengths[i];
    }
  }
}

void Ranks::RequireSame(const std::string& subject, const std::string& text) {
  if (count_ == 1) return;
  std::string of_root = text;
  std::uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  if (size > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
    throw Error(subject + " take more than 2 GiB of text; expected less.");
  }
  of_root.resize(size);
  MPI_Bcast(of_root.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
  if (Any(of_root != text)) {
    throw Error(subject + " of the ranks differ; expected the same on each of them.");
  }
}

void Ranks::Abort(int code) const {
  if (count_ > 1) MPI_Abort(MPI_COMM_WORLD, code);
}

}  // namespace warplut
