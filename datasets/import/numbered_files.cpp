#include "datasets/import/numbered_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>

#include "datasets/error.h"
#include "datasets/file.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

constexpr int kMostLevels = 3;
constexpr std::size_t kMostDigits = 9;

bool IsFrameFile(const fs::path& path) {
  constexpr std::array kExtensions = {".exr",  ".png", ".flo", ".dpt", ".jpg", ".tif",
                                      ".tiff", ".hdr", ".ppm", ".tga", ".bmp"};
  return std::any_of(kExtensions.begin(), kExtensions.end(),
                     [&](const char* extension) { return HasExtension(path, extension); });
}

std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '%' ? std::string("%%") : std::string(1, c);
  return escaped;
}

// Names that are alike but for the number: what is before and behind it, and its digits.
struct Split {
  std::string before, digits, behind;
};

bool SplitName(const std::string& name, Split* split) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t end = name.rfind('.');
  while (end > 0 && !is_digit(name[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && is_digit(name[begin - 1])) --begin;
  if (begin == end || end - begin > kMostDigits) return false;
  *split = {name.substr(0, begin), name.substr(begin, end - begin), name.substr(end)};
  return true;
}

}  // namespace

std::vector<NumberedFiles> FindNumberedFiles(const fs::path& folder) {
  // By what surrounds the number, the digits of each file.
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> groups;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, error);
  for (const fs::recursive_directory_iterator end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.front() == '.' || it.depth() >= kMostLevels) it.disable_recursion_pending();
    if (name.front() == '.' || !it->is_regular_file() || !IsFrameFile(it->path())) continue;
    Split split;
    if (!SplitName(name, &split)) continue;
    std::string parent = fs::relative(it->path().parent_path(), folder).generic_string() + "/";
    if (parent == "./") parent.clear();
    groups[{Escaped(parent + split.before), Escaped(split.behind)}].push_back(split.digits);
  }
  if (error) throw Error(fmt::format("cannot list '{}': {}", folder.string(), error.message()));

  std::vector<NumberedFiles> found;
  for (auto& [around, digits] : groups) {
    const std::size_t width = digits.front().size();
    const bool padded =
        std::all_of(digits.begin(), digits.end(), [&](const auto& d) { return d.size() == width; });
    NumberedFiles files;
    files.pattern =
        fmt::format("{}%{}d{}", around.first, padded && width > 1 ? fmt::format("0{}", width) : "",
                    around.second);
    for (const std::string& d : digits) files.numbers.push_back(std::stoi(d));
    std::sort(files.numbers.begin(), files.numbers.end());
    found.push_back(std::move(files));
  }
  return found;
}

}  // namespace warplut
