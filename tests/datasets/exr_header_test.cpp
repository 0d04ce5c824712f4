#include "datasets/images/exr_header.h"

#include <gtest/gtest.h>

#include <string>

#include "datasets/file.h"
#include "datasets/images/image_io.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

// The bytes of a small image, whose header has attributes of several types.
std::string WholeFile(const TemporaryFolder& folder) {
  WriteImage(folder / "whole.exr", Image(4, 3, 3), PixelType::kHalf);
  return ReadFile(folder / "whole.exr");
}

// With the bytes of the length of the first attribute of this type replaced.
std::string WithLength(std::string bytes, const std::string& type, const std::string& length) {
  const std::size_t at = bytes.find(std::string(1, '\0') + type + std::string(1, '\0'));
  EXPECT_NE(at, std::string::npos) << type;
  return bytes.replace(at + type.size() + 2, 4, length);
}

TEST(ExrHeader, OfAWholeFileIsAccepted) {
  const TemporaryFolder folder;
  WholeFile(folder);
  CheckExrHeader(folder / "whole.exr");
}

TEST(ExrHeader, LengthBeyondTheFileIsRefused) {
  const TemporaryFolder folder;
  const std::string bytes = WholeFile(folder);
  const std::string opaque = std::string("x\0opaque\0", 9) + std::string("\0\0\0\x64", 4);
  const std::size_t first = 8;  // after the magic number and the version
  WriteFile(folder / "long.exr", bytes.substr(0, first) + opaque + bytes.substr(first));
  ExpectError([&] { CheckExrHeader(folder / "long.exr"); },
              {"long.exr", "opaque", "1677721600", "at most"});
  ExpectError([&] { ReadImage(folder / "long.exr"); }, {"long.exr", "1677721600"});
}

TEST(ExrHeader, LengthThatItsTypeCannotHaveIsRefused) {
  const TemporaryFolder folder;
  const std::string bytes = WholeFile(folder);
  const std::string three("\3\0\0\0", 4);
  WriteFile(folder / "box.exr", WithLength(bytes, "box2i", three));
  ExpectError([&] { CheckExrHeader(folder / "box.exr"); }, {"box.exr", "box2i", "3", "16"});
  WriteFile(folder / "list.exr", WithLength(bytes, "chlist", three));
  // Three names of one letter with 16 bytes each, and the end of the list.
  ExpectError([&] { CheckExrHeader(folder / "list.exr"); }, {"list.exr", "chlist", "3", "55"});
}

TEST(ExrHeader, SidesBeyondTheLargestAreRefused) {
  const TemporaryFolder folder;
  std::string bytes = WholeFile(folder);
  const std::string window = std::string("dataWindow\0box2i\0", 17) + std::string("\x10\0\0\0", 4);
  const std::size_t at = bytes.find(window);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at + window.size() + 8, 4, std::string("\0\0\x55\0", 4));  // the largest x
  WriteFile(folder / "wide.exr", bytes);
  ExpectError([&] { CheckExrHeader(folder / "wide.exr"); },
              {"wide.exr", "5570561 x 3", "1 to 32768"});
}

TEST(ExrHeader, OtherFilesAreLeftToTheirReader) {
  const TemporaryFolder folder;
  WriteFile(folder / "short.exr", "v/1");
  WriteFile(folder / "other.exr", "no such file at all");
  CheckExrHeader(folder / "short.exr");
  CheckExrHeader(folder / "other.exr");
  const std::string bytes = WholeFile(folder);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    WriteFile(folder / "cut.exr", bytes.substr(0, length));
    try {
      CheckExrHeader(folder / "cut.exr");
    } catch (const Error& refused) {
      EXPECT_NE(std::string(refused.what()).find("attribute"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace warplut
