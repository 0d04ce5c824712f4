#include "datasets/temporary_file.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace warplut {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = ".tmp";

// The host and the namespace of its process numbers, as 8 digits.
const std::string& Machine() {
  static const std::string machine = [] {
    char host[256] = {};
    if (::gethostname(host, sizeof(host) - 1) != 0) host[0] = 0;
    std::error_code ignored;
    const std::string text = host + fs::read_symlink("/proc/self/ns/pid", ignored).string();
    std::uint32_t hash = 2166136261U;  // FNV-1a
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    return fmt::format("{:08x}", hash);
  }();
  return machine;
}

// The process that a temporary file of this machine was made by; nothing for other names.
std::optional<pid_t> MakerOf(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (mark == std::string_view::npos || !name.starts_with('.')) return std::nullopt;
  name = name.substr(0, mark);
  const std::size_t dot = name.rfind('.');
  if (dot == 0 || dot == std::string_view::npos) return std::nullopt;
  name = name.substr(dot + 1);
  if (!name.starts_with(Machine() + "-")) return std::nullopt;
  name = name.substr(Machine().size() + 1);
  pid_t process = 0;
  unsigned number = 0;
  const char* const end = name.data() + name.size();
  const auto [dash, wrong] = std::from_chars(name.data(), end, process);
  if (wrong != std::errc() || dash == end || *dash != '-' || process <= 0) return std::nullopt;
  const auto [rest, wrong_number] = std::from_chars(dash + 1, end, number);
  if (wrong_number != std::errc() || rest != end) return std::nullopt;
  return process;
}

bool IsGone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

fs::path TemporaryBeside(const fs::path& path) {
  constexpr std::size_t kMaxPart = 100;  // bytes of stem and extension that are kept
  static std::atomic<unsigned> counter{0};
  return path.parent_path() / fmt::format(".{}.{}-{}-{}{}{}",
                                          path.stem().string().substr(0, kMaxPart), Machine(),
                                          ::getpid(), counter.fetch_add(1), kMark,
                                          path.extension().string().substr(0, kMaxPart));
}

void RemoveStaleTemporaries(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> seen;
  std::error_code error;
  const fs::path absolute = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
  const std::lock_guard lock(mutex);
  if (error || !seen.insert(absolute).second) return;
  for (fs::directory_iterator it(absolute, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    const auto maker = MakerOf(name);
    std::error_code ignored;
    if (maker && IsGone(*maker) && it->is_regular_file(ignored)) fs::remove(it->path(), ignored);
  }
}

}  // namespace warplut
