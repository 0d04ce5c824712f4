// Clips that are loaded when they are needed, and as many of them kept as memory allows.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "train/replay/clip.h"

namespace warplut {

// Where a clip comes from: it is in memory, or on a shelf. Empty: there is none here.
class ClipSource {
 public:
  using Load = std::function<std::shared_ptr<const Clip>()>;

  ClipSource() = default;
  ClipSource(std::shared_ptr<const Clip> clip) {  // NOLINT: a clip is the source of itself
    if (clip) load_ = [clip = std::move(clip)] { return clip; };
  }
  explicit ClipSource(Load load) : load_(std::move(load)) {}

  explicit operator bool() const { return static_cast<bool>(load_); }
  // The clip, the same pixels each time; held as long as the caller holds the pointer.
  std::shared_ptr<const Clip> Take() const { return load_(); }

 private:
  Load load_;
};

// Bytes of the buffers of its frames.
std::size_t ClipBytes(const Clip& clip);

// Holds clips up to a number of bytes (ClipBytes). Where the next one finds no room, the one that
// was loaded last goes first: a cycle over all clips finds as many as possible still there, and
// loads the others once. Not for several threads at once.
class ClipShelf {
 public:
  explicit ClipShelf(std::size_t most_bytes = 0);  // 0: no limit
  ~ClipShelf();
  ClipShelf(const ClipShelf&) = delete;
  ClipShelf& operator=(const ClipShelf&) = delete;

  // A clip that `load` makes, the same each time. It is loaded when it is taken first. The shelf
  // outlives the source. An Error of Take, beside those of `load`: the clip alone has more bytes
  // than the limit.
  ClipSource Add(std::function<Clip()> load);

  std::size_t held() const;       // bytes now
  std::size_t most_held() const;  // at any time; clips that callers still hold do not count
  int loads() const;              // calls of `load` so far

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warplut
