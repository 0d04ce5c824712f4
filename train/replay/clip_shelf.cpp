#include "train/replay/clip_shelf.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "datasets/error.h"

namespace warplut {

struct ClipShelf::State {
  struct Place {
    std::function<Clip()> load;
    std::shared_ptr<const Clip> clip;  // null: not in memory
    std::size_t bytes = 0;             // of the clip, once it was loaded
  };

  std::shared_ptr<const Clip> Take(std::size_t index) {
    Place& place = places[index];
    if (place.clip) return place.clip;
    // Before the clip is read there is room for the largest that was seen.
    MakeRoom(largest);
    auto clip = std::make_shared<const Clip>(place.load());
    ++loads;
    place.bytes = ClipBytes(*clip);
    largest = std::max(largest, place.bytes);
    if (most_bytes > 0 && place.bytes > most_bytes) {
      throw Error(fmt::format(
          "the clip of '{}' takes {} KiB in memory; expected at most the limit of {} KiB",
          clip->name, (place.bytes + 1023) >> 10, most_bytes >> 10));
    }
    MakeRoom(place.bytes);
    place.clip = clip;
    held += place.bytes;
    most_held = std::max(most_held, held);
    in_memory.push_back(index);
    return clip;
  }

  void MakeRoom(std::size_t bytes) {
    while (most_bytes > 0 && !in_memory.empty() && held + bytes > most_bytes) {
      Place& last = places[in_memory.back()];
      in_memory.pop_back();
      held -= last.bytes;
      last.clip.reset();
    }
  }

  std::size_t most_bytes = 0;
  std::vector<Place> places;
  std::vector<std::size_t> in_memory;  // in the order in which they were loaded
  std::size_t largest = 0;             // bytes of a clip so far
  std::size_t held = 0, most_held = 0;
  int loads = 0;
};

std::size_t ClipBytes(const Clip& clip) {
  std::size_t bytes = 0;
  for (const ClipFrame& frame : clip.frames) {
    bytes += frame.color.bytes() + frame.depth.bytes() + frame.motion.bytes() +
             frame.reference.bytes() + frame.reference_depth.bytes() +
             frame.reference_motion.bytes() + frame.reactive.bytes();
  }
  return bytes;
}

ClipShelf::ClipShelf(std::size_t most_bytes) : state_(std::make_unique<State>()) {
  state_->most_bytes = most_bytes;
}

ClipShelf::~ClipShelf() = default;

ClipSource ClipShelf::Add(std::function<Clip()> load) {
  const std::size_t index = state_->places.size();
  state_->places.push_back({.load = std::move(load), .clip = nullptr, .bytes = 0});
  return ClipSource([state = state_.get(), index] { return state->Take(index); });
}

std::size_t ClipShelf::held() const { return state_->held; }
std::size_t ClipShelf::most_held() const { return state_->most_held; }
int ClipShelf::loads() const { return state_->loads; }

}  // namespace warplut
