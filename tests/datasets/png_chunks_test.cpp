#include "datasets/images/png_chunks.h"

#include <gtest/gtest.h>

#include <string>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

class PngChunks : public testing::Test {
 protected:
  void SetUp() override {
    Image image(40, 30, 3);
    for (std::size_t i = 0; i < image.data.size(); ++i) {
      image.data[i] = static_cast<float>(i * 37 % 256) / 255;
    }
    WriteImage(file_, image, PixelType::kUint8);
    bytes_ = ReadFile(file_);
  }

  void ExpectRefused(const std::string& bytes, const std::string& piece) {
    WriteFile(file_, bytes);
    testing::internal::CaptureStderr();
    ExpectError([&] { ReadImage(file_); }, {piece});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");  // of the library
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "a.png";
  std::string bytes_;
};

TEST_F(PngChunks, OfAWholeFileAreAccepted) {
  CheckPngChunks(file_, true);
  WriteFile(file_, bytes_ + "what follows the last chunk");
  EXPECT_EQ(ReadImage(file_).width, 40);
}

TEST_F(PngChunks, FilesCutOffAnywhereAreRefused) {
  for (std::size_t length = 8; length < bytes_.size(); length += 1 + length / 16) {
    SCOPED_TRACE(length);
    ExpectRefused(bytes_.substr(0, length), "it is cut off");
  }
}

TEST_F(PngChunks, DamageAnywhereBehindTheSignatureIsRefused) {
  for (std::size_t at = 8; at < bytes_.size(); at += 1 + at / 16) {
    SCOPED_TRACE(at);
    std::string damaged = bytes_;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    ExpectRefused(damaged, "it is ");  // cut off where a length grew, else damaged
  }
}

TEST_F(PngChunks, PixelsAreNotReadForTheHeader) {
  std::string damaged = bytes_;
  damaged[bytes_.find("IDAT") + 20] ^= 1;
  WriteFile(file_, damaged);
  CheckPngChunks(file_, false);
  EXPECT_EQ(ReadImageInfo(file_).height, 30);
}

TEST_F(PngChunks, OtherFilesAreLeftToTheirReaders) {
  WriteFile(file_, "GIF89a");
  CheckPngChunks(file_, true);
  WriteFile(file_, "");
  CheckPngChunks(file_, true);
}

}  // namespace
}  // namespace warplut
