#include "datasets/images/flo_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

std::string Flo(std::int32_t width, std::int32_t height, const std::vector<float>& values) {
  std::string bytes = "PIEH";
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(width);
  append(height);
  for (const float value : values) append(value);
  return bytes;
}

TEST(ReadFlo, TellsWhatIsUnknown) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.FLO";
  WriteFile(path, Flo(3, 2, {1, -2, 3, 4, 1e10f, 0, 0, -1.1e9f, std::nanf(""), 1, 1e9f, 5}));
  const ImageInfo info = ReadImageInfo(path);
  EXPECT_EQ(info.width, 3);
  EXPECT_EQ(info.height, 2);
  EXPECT_EQ(info.channels, (std::vector<std::string>{"X", "Y"}));
  const Image flow = ReadImage(path, {}, Values::kAll);
  EXPECT_EQ(flow.at(0, 0, 1), -2);
  EXPECT_EQ(flow.at(1, 0, 0), 3);
  EXPECT_EQ(flow.at(2, 1, 0), 1e9f);
  for (const auto& [x, y] : {std::pair(2, 0), std::pair(0, 1), std::pair(1, 1)}) {
    EXPECT_TRUE(std::isnan(flow.at(x, y, 0)) && std::isnan(flow.at(x, y, 1))) << x << ", " << y;
  }
  EXPECT_EQ(ReadImage(path, {"y", "X"}, Values::kAll).at(1, 0, 0), 4);
  ExpectError([&] { ReadImage(path); }, {"a.FLO", "pixel (2, 0)", "channel X", "finite"});
  ExpectError([&] { ReadImage(path, {"R"}, Values::kAll); }, {"a.FLO", "no channel 'R'"});
}

TEST(ReadFlo, RefusesWhatIsDamaged) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "a.flo";
  const std::string whole = Flo(2, 1, {1, 2, 3, 4});
  const auto refused = [&](const std::string& bytes, const std::string& piece) {
    WriteFile(path, bytes);
    ExpectError([&] { ReadFlo(path); }, {"a.flo", piece});
    ExpectError([&] { ReadFloInfo(path); }, {"a.flo", piece});
  };
  refused("", "begins with PIEH");
  refused("PIEH", "begins with PIEH");
  refused("PIEX" + whole.substr(4), "begins with PIEH");
  refused(whole.substr(0, whole.size() - 1), "it is 27 bytes long; expected 28");
  refused(whole + "x", "it is 29 bytes long; expected 28");
  refused(Flo(0, 1, {}), "0 x 1");
  refused(Flo(1, 40'000, {}), "1 x 40000");
  refused(Flo(-1, -1, {1, 2}), "-1 x -1");
  ExpectError([&] { ReadFlo(folder / "none.flo"); }, {"none.flo", "does not exist"});
}

}  // namespace
}  // namespace warplut
