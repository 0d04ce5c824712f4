// Pictures for the eye: error colours, labels, windows, animations.
#include "tools/view/view_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"
#include "tests/tools/test_images.h"
#include "tools/view/error_map.h"
#include "tools/view/flip_picture.h"
#include "tools/view/picture_label.h"

namespace warplut {
namespace {

Image Plain(int width, int height, float value) {
  Image image(width, height, 3);
  std::fill(image.data.begin(), image.data.end(), value);
  return image;
}

double Brightness(const Image& image, int x, int y) {
  return image.at(x, y, 0) + image.at(x, y, 1) + image.at(x, y, 2);
}

TEST(ErrorMap, IsBrighterWhereTheErrorIsLarger) {
  const Image truth = Plain(4, 1, 0.5f);
  Image image = truth;
  image.at(1, 0, 2) += 0.05f;
  image.at(2, 0, 0) -= 0.2f;
  image.at(3, 0, 1) += 0.5f;
  const Image map = ErrorMap(image, truth, 4);
  EXPECT_LT(Brightness(map, 0, 0), 0.05);
  EXPECT_LT(Brightness(map, 0, 0), Brightness(map, 1, 0));
  EXPECT_LT(Brightness(map, 1, 0), Brightness(map, 2, 0));
  EXPECT_GT(Brightness(map, 3, 0), 2.5);
  EXPECT_GT(map.at(2, 0, 0), map.at(2, 0, 2)) << "orange, R before B";
  EXPECT_EQ(ErrorLegend(4), "x 4: black is 0, pale yellow is 0.25 or more");
}

TEST(PictureLabel, StandsAboveThePicture) {
  const Image picture = Plain(200, 30, 0.25f);
  const Image labelled = Labelled(picture, "frame 0008");
  EXPECT_EQ(labelled.width, 200);
  EXPECT_EQ(labelled.height, 30 + kLabelHeight);
  EXPECT_TRUE(std::equal(
      picture.data.begin(), picture.data.end(),
      labelled.data.begin() + static_cast<std::ptrdiff_t>(labelled.Index(0, kLabelHeight))));
  const auto end =
      labelled.data.begin() + static_cast<std::ptrdiff_t>(labelled.Index(0, kLabelHeight));
  EXPECT_LT(*std::min_element(labelled.data.begin(), end), 0.3f) << "letters";
  EXPECT_EQ(Labelled(Plain(5, 5, 0), std::string(300, 'w')).width, 5);
}

TEST(PictureLabel, SmallerPicturesAreAverages) {
  const Image small = AtMostWide(Plain(400, 100, 0.25f), 100);
  EXPECT_EQ(small.width, 100);
  EXPECT_EQ(small.height, 25);
  EXPECT_NEAR(small.at(50, 12, 1), 0.25f, 1e-6f);
  EXPECT_EQ(AtMostWide(Plain(40, 10, 0), 100).width, 40);
}

std::string PngOf(const TemporaryFolder& folder, const Image& image) {
  WriteImage(folder / "a.png", image, PixelType::kUint8);
  return ReadFile(folder / "a.png");
}

TEST(FlipPicture, IsAPngThatShowsTheFirstAndHoldsBoth) {
  const TemporaryFolder folder;
  const Image a = WavyImage(40, 30), b = Plain(40, 30, 0.5f);
  const std::string first = PngOf(folder, a), second = PngOf(folder, b);
  const std::string flip = FlipPicture(first, second, 600);
  WriteFile(folder / "flip.png", flip);
  WriteFile(folder / "first.png", first);
  EXPECT_EQ(ReadImage(folder / "flip.png").data, ReadImage(folder / "first.png").data);
  for (const char* chunk : {"acTL", "fcTL", "fdAT"}) {
    EXPECT_THAT(flip, testing::HasSubstr(chunk));
  }
  EXPECT_GE(flip.size(), first.size() + second.size() - 200);
}

TEST(FlipPicture, RefusesWhatDoesNotFit) {
  const TemporaryFolder folder;
  const std::string png = PngOf(folder, Plain(8, 8, 0));
  ExpectError([&] { FlipPicture(png, PngOf(folder, Plain(8, 9, 0)), 1); }, {"differ in size"});
  ExpectError([&] { FlipPicture("text", png, 1); }, {"no PNG"});
  ExpectError([&] { FlipPicture(png, png.substr(0, png.size() / 2), 1); }, {"no PNG"});
}

ViewedFrames Sources() { return {.a = "one", .b = "two", .files = {}}; }

TEST(WorstWindows, AreThoseOfTheLargestError) {
  const ViewedFrames sources = Sources();
  WorstWindows worst(sources);
  for (std::size_t i = 0; i < 3; ++i) {
    ViewedFrame frame{.name = "f",
                      .a = Plain(400, 300, 0.5f),
                      .b = Plain(400, 300, 0.5f),
                      .reference = Plain(400, 300, 0.5f)};
    if (i == 1) frame.a.at(300, 200, 0) = 1;
    if (i == 2) frame.b.at(10, 10, 0) = 1;
    if (i == 2) frame.a.at(10, 10, 0) = 0.6f;
    worst.Add(i, frame);
  }
  const std::vector<WorstWindow> found = worst.Worst();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].source, "one");
  EXPECT_EQ(found[0].index, 1U);
  EXPECT_LE(found[0].window.x, 300);
  EXPECT_GT(found[0].window.x + kWindowSide, 300);
  EXPECT_EQ(found[1].source, "two");
  EXPECT_EQ(found[1].index, 2U);
  EXPECT_EQ(found[1].window.x, 0);
  EXPECT_TRUE(WorstWindows(sources).Worst().empty());
}

TEST(ViewPictures, PanelsAreBothTheReferenceAndTheErrors) {
  ViewedFrame frame{.name = "f", .a = Plain(90, 60, 0), .b = Plain(90, 60, 0.1f), .reference = {}};
  EXPECT_EQ(PanelsOf(Sources(), frame, 2).size(), 3U);
  frame.reference = Plain(90, 60, 0.1f);
  const std::vector<NamedPanel> panels = PanelsOf(Sources(), frame, 2);
  ASSERT_EQ(panels.size(), 5U);
  EXPECT_EQ(panels[3].Label(), "error of one x 2");
  EXPECT_GT(Brightness(panels[3].image, 0, 0), Brightness(panels[4].image, 0, 0));
  ContactSheet sheet;
  sheet.Add("f", panels);
  sheet.Add("g", panels);
  const Image picture = sheet.Picture("title");
  EXPECT_EQ(picture.width, 5 * 90 + 4 * kPicturePanelGap);
  EXPECT_EQ(picture.height, 3 * kLabelHeight + 2 * 60 + kPicturePanelGap);
  const Image moment = MomentPicture("f", panels);
  EXPECT_EQ(moment.height, 2 * (60 + kLabelHeight) + kPicturePanelGap);
  EXPECT_EQ(WindowPicture("w", panels, {}).height, 60 * kWindowZoom + 2 * kLabelHeight);
}

}  // namespace
}  // namespace warplut
