#include "tools/terminal/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace warplut {
namespace {

constexpr std::chrono::milliseconds kInterval{100};

std::string Duration(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 120) return fmt::format("{} s", whole);
  return fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

}  // namespace

std::string ProgressLine(const std::string& label, double done, double total,
                         const std::string& unit, double seconds, const std::string& note) {
  const double share = total > 0 ? std::clamp(done / total, 0.0, 1.0) : 0.0;
  std::string line = label;
  if (!unit.empty()) line += fmt::format(" {:.0f}/{:.0f} {}", done, total, unit);
  line += fmt::format("  {:.0f} %", 100 * share);
  if (done > 0 && seconds > 0) {
    if (!unit.empty()) line += fmt::format("  {:.3g} {}/s", done / seconds, unit);
    line += fmt::format("  {} left", Duration(seconds * (1 - share) / share));
  }
  if (!note.empty()) line += "  " + note;
  return line;
}

Progress::Progress(std::string label, double total, std::string unit)
    : label_(std::move(label)),
      unit_(std::move(unit)),
      total_(total),
      shown_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::Update(double done, const std::string& note) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  Show(note);
}

void Progress::Add(double units) {
  const std::lock_guard lock(mutex_);
  done_ += units;
  Show({});
}

void Progress::Show(const std::string& note) {
  const Clock::time_point now = Clock::now();
  if (!shown_ || now - last_ < kInterval) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r{}\033[K", ProgressLine(label_, done_, total_, unit_, seconds, note));
  std::fflush(stderr);
}

}  // namespace warplut
