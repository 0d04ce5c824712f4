#include "datasets/hash.h"

#include <gtest/gtest.h>

#include <string>

#include "datasets/file.h"
#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

// Vectors of FIPS 180 and of its examples.
TEST(Sha1, KnownValues) {
  EXPECT_EQ(Sha1(""), "da39a3ee5e6b4b0d3255bfef95601890afd80709");
  EXPECT_EQ(Sha1("abc"), "a9993e364706816aba3e25717850c26c9cd0d89d");
  EXPECT_EQ(Sha1("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "84983e441c3bd26ebaae4aa1f95129e5e54670f1");
  EXPECT_EQ(Sha1(std::string(1'000'000, 'a')), "34aa973cd4c4daa4f61eeb2bdbad27316534016f");
}

TEST(Sha1, PaddingAtBlockBoundaries) {
  EXPECT_EQ(Sha1(std::string(55, 'a')), "c1c8bbdc22796e28c0e15163d20899b65621d65a");
  EXPECT_EQ(Sha1(std::string(56, 'a')), "c2db330f6083854c99d4b5bfb6e8f29f201be699");
  EXPECT_EQ(Sha1(std::string(64, 'a')), "0098ba824b5c16427bd7a1122a5a442a25ec644d");
}

TEST(Sha1, OfAFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  const std::string bytes(200'000, '\x80');
  WriteFile(folder / "a", bytes);
  EXPECT_EQ(Sha1OfFile(folder / "a"), Sha1(bytes));
  ExpectError([&] { Sha1OfFile(folder / "none"); }, {"none", "not a regular file"});
}

}  // namespace
}  // namespace warplut
