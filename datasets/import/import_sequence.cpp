#include "datasets/import/import_sequence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "datasets/error.h"
#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "datasets/import/capture.h"
#include "datasets/import/dpt_file.h"
#include "datasets/import/numbered_files.h"
#include "datasets/json_fields.h"
#include "datasets/sequence/frame_pattern.h"
#include "datasets/text_case.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

bool EndsWith(const std::string& text, const std::string& end) {
  if (text.size() < end.size()) return false;
  if (text.compare(text.size() - end.size(), end.size(), end) != 0) return false;
  // A whole name: "Depth.Z" is the end of "View.Depth.Z" and not of "NoDepth.Z".
  return text.size() == end.size() || text[text.size() - end.size() - 1] == '.' ||
         text[text.size() - end.size() - 1] == '_';
}

bool IsReference(const std::string& pattern) {
  const std::string first = LowerCase(pattern.substr(0, pattern.find('/')));
  constexpr std::array kFolders = {"hr",  "hr_inputs", "reference",    "references",
                                   "ref", "gt",        "ground_truth", "motion_gt"};
  return pattern.find('/') != std::string::npos &&
         std::any_of(kFolders.begin(), kFolders.end(),
                     [&](const char* folder) { return first == folder; });
}

// One stream as it was found: files, and channels of them where they must be named.
struct Found {
  NumberedFiles files;
  std::vector<std::string> channels;
};

class Importer {
 public:
  explicit Importer(const ImportRequest& request)
      : request_(request), preset_(FindImportPreset(request.preset)) {
    if (!fs::is_directory(request.folder)) {
      throw Error(fmt::format("'{}' is not a folder", request.folder.string()));
    }
    files_ = FindNumberedFiles(request.folder);
    if (files_.empty()) {
      throw Error(fmt::format("'{}' has no numbered images; expected frames like 0001.exr",
                              request.folder.string()));
    }
    if (!preset_.captures) return;
    const Capture capture = FindCapture(files_, request.capture, request.scale);
    std::erase_if(files_, [&](const auto& f) { return !IsOfCapture(capture, f.pattern); });
    const fs::path metadata = request.folder / (capture.name + ".json");
    capture_ = ReadCaptureMetadata(metadata);
  }

  ImportResult Run() {
    const auto color = Find(preset_.color, false);
    if (!color) {
      throw Error(fmt::format("'{}' has no colour that the preset '{}' knows; found {}",
                              request_.folder.string(), preset_.name, Patterns()));
    }
    Describe(*color);
    AddDepth(Find(preset_.depth, false), false);
    AddMotion(false);
    if (const auto reference = Find(preset_.color, true)) {
      sequence_.reference = ColorStream{reference->files.pattern, reference->channels};
      sequence_.output = SizeOf(*reference);
      AddDepth(Find(preset_.depth, true), true);
      AddMotion(true);
    }
    if (sequence_.depth && !request_.far && sequence_.depth->kind == DepthKind::kLinear &&
        sequence_.depth->encoding == Encoding::kFloat) {
      notes_.push_back(fmt::format("The far plane is {:.6g}, the largest depth that was found.",
                                   sequence_.depth->far));
    }
    AddMasks();
    AddCapture();
    Write();
    return {Manifest(), ReadSequence(Manifest()), std::move(notes_)};
  }

 private:
  std::string Patterns() const {
    std::vector<std::string> patterns;
    for (const NumberedFiles& files : files_) patterns.push_back("'" + files.pattern + "'");
    return fmt::format("{}", fmt::join(patterns, ", "));
  }

  fs::path FirstFile(const NumberedFiles& files) const {
    return request_.folder / FrameFileName(files.pattern, files.numbers.front());
  }

  // The files whose path has one of the words, and whose channels are one of the alternatives. A
  // preset without words takes any file.
  std::optional<Found> Find(const StreamNamesOfTool& names, bool reference) const {
    std::vector<std::string> words = names.words;
    if (words.empty()) words.emplace_back("");
    for (const std::string& word : words) {
      for (const NumberedFiles& files : files_) {
        if (IsReference(files.pattern) != reference) continue;
        if (LowerCase(files.pattern).find(word) == std::string::npos) continue;
        if (auto channels = ChannelsOf(files, names)) return Found{files, std::move(*channels)};
      }
    }
    // Several streams in one file have no word in its path.
    if (names.words.empty()) return std::nullopt;
    for (const NumberedFiles& files : files_) {
      if (IsReference(files.pattern) != reference) continue;
      const auto channels = ChannelsOf(files, names);
      if (!channels || channels->empty()) continue;
      const bool layered = channels->front().find('.') != std::string::npos;
      if (layered || &names == &preset_.color) return Found{files, *channels};
    }
    return std::nullopt;
  }

  fs::path Manifest() const {
    if (request_.capture.empty()) return request_.folder / Sequence::kManifest;
    return request_.folder / fmt::format("sequence-{}.json", request_.capture);
  }

  // Jitter and cuts of the frames that there are.
  void AddCapture() {
    if (!capture_) return;
    for (int index = 0; index < sequence_.count; ++index) {
      const int number = sequence_.Number(index);
      const auto jitter = capture_->jitter.find(number);
      if (jitter == capture_->jitter.end()) {
        throw Error(fmt::format("the capture's JSON has no frame {}, which has a colour", number));
      }
      sequence_.jitter.push_back(jitter->second);
      const bool cut = std::binary_search(capture_->cuts.begin(), capture_->cuts.end(), number);
      if (cut &&
          std::find(sequence_.cuts.begin(), sequence_.cuts.end(), number) == sequence_.cuts.end()) {
        sequence_.cuts.push_back(number);
      }
    }
    std::sort(sequence_.cuts.begin(), sequence_.cuts.end());
  }

  // The names to take; empty: all that the file has.
  std::optional<std::vector<std::string>> ChannelsOf(const NumberedFiles& files,
                                                     const StreamNamesOfTool& names) const {
    const fs::path file = FirstFile(files);
    if (HasExtension(file, ".flo") || HasExtension(file, ".dpt")) {
      const bool fits =
          &names != &preset_.color && HasExtension(file, ".flo") == (&names == &preset_.motion);
      return fits ? std::optional(std::vector<std::string>()) : std::nullopt;
    }
    if (names.channels.empty()) return std::vector<std::string>();
    for (const auto& ends : names.channels) {
      for (const ImagePart& part : ReadImageParts(file)) {
        std::vector<std::string> channels;
        for (const std::string& end : ends) {
          const auto at = std::find_if(part.channels.begin(), part.channels.end(),
                                       [&](const auto& c) { return EndsWith(c, end); });
          if (at != part.channels.end()) channels.push_back(*at);
        }
        if (channels.size() == ends.size()) return channels;
      }
    }
    return std::nullopt;
  }

  GridSize SizeOf(const Found& found) const {
    const ImageInfo info = ReadImageInfo(FirstFile(found.files), found.channels);
    return {info.width, info.height};
  }

  // The largest size of a frame; all of them where they differ.
  GridSize RenderSize(const Found& color) {
    GridSize largest;
    bool differ = false;
    std::vector<GridSize> sizes;
    for (const int number : color.files.numbers) {
      const ImageInfo info = ReadImageInfo(
          request_.folder / FrameFileName(color.files.pattern, number), color.channels);
      sizes.push_back({info.width, info.height});
      differ = differ || sizes.back() != sizes.front();
      largest = {std::max(largest.width, info.width), std::max(largest.height, info.height)};
    }
    if (differ) {
      notes_.push_back(fmt::format("The sizes of frames differ; the largest is {} x {}.",
                                   largest.width, largest.height));
      sequence_.render_sizes = std::move(sizes);
    }
    return largest;
  }

  AlphaKind AlphaKindOf(const std::string& pattern) const {
    return HasExtension(pattern, ".exr") ? AlphaKind::kPremultiplied : AlphaKind::kStraight;
  }

  // The channel that ends the colour's layer: `A`, or `LAYER.A` beside `LAYER.R`.
  AlphaStream AlphaOf(const ColorStream& color) const {
    std::string name = "A";
    if (!color.channels.empty()) {
      const std::string& red = color.channels.front();
      const std::size_t dot = red.rfind('.');
      if (dot != std::string::npos) name = red.substr(0, dot + 1) + name;
    }
    return {color.path, {name}, AlphaKindOf(color.path)};
  }

  void AddMasks() {
    if (!request_.reactive.empty()) {
      sequence_.reactive = MaskStream{request_.reactive, OneChannel(request_.reactive)};
    }
    if (!request_.hud.empty()) {
      sequence_.hud = LayerStream{request_.hud, {}, AlphaKindOf(request_.hud)};
    }
    if (!request_.alpha) return;
    sequence_.alpha = AlphaOf(sequence_.color);
    if (sequence_.reference) sequence_.reference_alpha = AlphaOf(*sequence_.reference);
  }

  // The first channel, where a file of the pattern has several.
  std::vector<std::string> OneChannel(const std::string& pattern) const {
    if (!IsFramePattern(pattern)) return {};  // refused where the manifest is written
    const ImageInfo info = ReadImageInfo(request_.folder / FrameFileName(pattern, sequence_.first));
    return info.channels.size() > 1 ? std::vector{info.channels.front()}
                                    : std::vector<std::string>();
  }

  void Describe(const Found& color) {
    sequence_.folder = request_.folder;
    sequence_.name = request_.name;
    if (sequence_.name.empty()) {
      sequence_.name = fs::weakly_canonical(request_.folder).filename().string();
    }
    const std::vector<int>& numbers = color.files.numbers;
    sequence_.first = numbers.front();
    sequence_.count = static_cast<int>(numbers.size());
    if (numbers.back() - numbers.front() + 1 != sequence_.count) {
      sequence_.numbers = numbers;
      for (std::size_t i = 1; i < numbers.size(); ++i) {
        if (numbers[i] != numbers[i - 1] + 1) sequence_.cuts.push_back(numbers[i]);
      }
      notes_.push_back(
          fmt::format("The frame numbers have gaps; the frames after them ({}) are "
                      "cuts.",
                      fmt::join(sequence_.cuts, ", ")));
    }
    sequence_.color = {color.files.pattern, color.channels};
    sequence_.render = sequence_.output = RenderSize(color);
    sequence_.output.width = static_cast<int>(std::lround(sequence_.render.width * request_.scale));
    sequence_.output.height =
        static_cast<int>(std::lround(sequence_.render.height * request_.scale));
    const ImageInfo info = ReadImageInfo(FirstFile(color.files), color.channels);
    sequence_.color_space = info.integer ? ColorSpace::kSrgb : preset_.color_space;
  }

  void AddDepth(std::optional<Found> found, bool reference) {
    if (!found) {
      if (!reference) notes_.emplace_back("No depth was found; super resolution needs it.");
      return;
    }
    if (HasExtension(FirstFile(found->files), ".dpt")) ConvertDepth(&found->files, reference);
    DepthStream stream = preset_.depth_stream;
    stream.path = found->files.pattern;
    stream.channels = found->channels;
    if (capture_) {
      stream.kind = capture_->reversed_depth ? DepthKind::kReversed : DepthKind::kForward;
      stream.near = capture_->near;
      stream.far = capture_->far;
    }
    if (request_.near) stream.near = *request_.near;
    if (stream.kind != DepthKind::kLinear) {
      if (!(stream.near > 0)) {
        throw Error(fmt::format("depth of the preset '{}' is that of a projection; expected --near",
                                preset_.name));
      }
      if (!capture_) stream.far = HUGE_VAL;
      if (request_.far) stream.far = *request_.far;
    } else if (stream.encoding == Encoding::kFloat) {
      stream.far = request_.far ? *request_.far : LargestDepth(*found, stream);
    }
    (reference ? sequence_.reference_depth : sequence_.depth) = stream;
    if (reference && sequence_.depth && stream.kind == DepthKind::kLinear &&
        stream.encoding == Encoding::kFloat) {
      // One far plane for both grids: depths of both are compared.
      sequence_.depth->far = sequence_.reference_depth->far =
          std::max(sequence_.depth->far, sequence_.reference_depth->far);
    }
  }

  double LargestDepth(const Found& found, const DepthStream& stream) const {
    const double background = stream.background.value_or(HUGE_VAL);
    double largest = stream.near;
    for (const int number : found.files.numbers) {
      const Image depth = ReadImage(request_.folder / FrameFileName(found.files.pattern, number),
                                    found.channels, Values::kAll);
      for (const float z : depth.data) {
        if (std::isfinite(z) && z < 0.999 * background) largest = std::max<double>(largest, z);
      }
    }
    return largest > stream.near ? largest : stream.near + 1;
  }

  // Sintel's depth to OpenEXR, as floats.
  void ConvertDepth(NumberedFiles* files, bool reference) {
    const std::string pattern = fmt::format("depth_exr/{}%04d.exr", reference ? "reference_" : "");
    CreateFolder(request_.folder / "depth_exr");
    for (const int number : files->numbers) {
      WriteImage(request_.folder / FrameFileName(pattern, number),
                 ReadDpt(request_.folder / FrameFileName(files->pattern, number)),
                 PixelType::kFloat, {"Z"});
    }
    notes_.push_back(
        fmt::format("{} depth files were converted to '{}'.", files->numbers.size(), pattern));
    files->pattern = pattern;
  }

  void AddMotion(bool reference) {
    MotionStream stream = preset_.motion_stream;
    if (preset_.two_motion_files) {
      for (const NumberedFiles& files : files_) {
        if (IsReference(files.pattern) != reference) continue;
        const std::string path = LowerCase(files.pattern);
        if (path.find(preset_.motion.words.front() + "_x") != std::string::npos) {
          stream.path_x = files.pattern;
        }
        if (path.find(preset_.motion.words.front() + "_y") != std::string::npos) {
          stream.path_y = files.pattern;
        }
      }
      if (stream.path_x.empty() || stream.path_y.empty()) {
        if (!reference) notes_.emplace_back("No motion was found; nothing can be warped.");
        return;
      }
    } else {
      const auto found = Find(preset_.motion, reference);
      if (!found) {
        if (!reference) notes_.emplace_back("No motion was found; nothing can be warped.");
        return;
      }
      stream.path = found->files.pattern;
      stream.channels = found->channels;
    }
    (reference ? sequence_.reference_motion : sequence_.motion) = stream;
  }

  void Write() {
    const fs::path manifest = Manifest();
    if (fs::exists(manifest) && !request_.replace) {
      throw Error(fmt::format("'{}' is there already; expected a folder without one, or --replace",
                              manifest.string()));
    }
    auto json = nlohmann::ordered_json::parse(SequenceJson(sequence_));
    if (!request_.fields.empty()) {
      const nlohmann::json extra = ReadJson(request_.fields, kMaxManifestBytes);
      JsonFields fields(extra, JsonPlace(request_.fields.string(), ""));
      for (const char* field : kImportFields) {
        if (fields.Has(field))
          json[field] = nlohmann::ordered_json::parse(fields.Take(field).dump());
      }
      fields.Finish();
      if (json.contains("exposures")) json["version"] = 2;
    }
    const std::string before = fs::exists(manifest) ? ReadFile(manifest) : "";
    WriteFile(manifest, JsonText(json, 1) + "\n");
    try {
      const Sequence read = ReadSequence(manifest);
      WriteFile(manifest, SequenceJson(read));
    } catch (const Error&) {
      if (before.empty()) {
        fs::remove(manifest);
      } else {
        WriteFile(manifest, before);
      }
      throw;
    }
  }

  const ImportRequest& request_;
  const ImportPreset& preset_;
  std::vector<NumberedFiles> files_;
  std::optional<CaptureMetadata> capture_;  // of the preset arm
  Sequence sequence_;
  std::vector<std::string> notes_;
};

}  // namespace

ImportResult ImportSequence(const ImportRequest& request) { return Importer(request).Run(); }

}  // namespace warplut
