#include "datasets/file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <fstream>
#include <stdexcept>

#include "tests/datasets/expect_error.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

// Writes beyond `bytes` fail with EFBIG while it lives, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    handler_ = ::signal(SIGXFSZ, SIG_IGN);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST(WriteFile, ReplacesTheWholeFile) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b", 3);
  WriteFile(folder / "f.txt", "longer than that");
  WriteFile(folder / "f.txt", bytes);
  EXPECT_EQ(ReadFile(folder / "f.txt"), bytes);
  WriteFile(folder / "f.txt", "");
  EXPECT_EQ(ReadFile(folder / "f.txt"), "");
  EXPECT_EQ(folder.Entries(), 1U);
}

TEST(WriteFile, TakesTheLongestName) {
  const TemporaryFolder folder;
  for (const std::string& name :
       {std::string(255, 'n'), std::string(251, 'n') + ".png", "a." + std::string(253, 'x')}) {
    WriteFile(folder / name, name);
    EXPECT_EQ(ReadFile(folder / name), name);
  }
  EXPECT_EQ(folder.Entries(), 3U);
}

TEST(WriteFile, FullDiskLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  WriteFile(folder / "f.txt", "old");
  {
    const FileSizeLimit limit(1000);
    ExpectError([&] { WriteFile(folder / "f.txt", std::string(5000, 'x')); },
                {"f.txt", "write failed"});
  }
  EXPECT_EQ(ReadFile(folder / "f.txt"), "old");
  EXPECT_EQ(folder.Entries(), 1U);
}

TEST(WriteAtomically, TemporaryIsBesideWithTheSameExtension) {
  const TemporaryFolder folder;
  WriteAtomically(folder / "f.png", [&](const std::filesystem::path& temporary) {
    EXPECT_EQ(temporary.parent_path(), folder.path());
    EXPECT_EQ(temporary.extension(), ".png");
    EXPECT_FALSE(std::filesystem::exists(folder / "f.png"));
    std::ofstream(temporary) << "x";
  });
  EXPECT_EQ(ReadFile(folder / "f.png"), "x");
}

TEST(WriteAtomically, FailureLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  WriteFile(folder / "f", "old");
  const auto half = [](const std::filesystem::path& temporary) {
    std::ofstream(temporary) << "half";
  };
  ExpectError(
      [&] {
        WriteAtomically(folder / "f", [&](const auto& temporary) {
          half(temporary);
          throw std::runtime_error("the encoder failed");
        });
      },
      {"/f'", "the encoder failed"});
  EXPECT_THROW(WriteAtomically(folder / "f",
                               [&](const auto& temporary) {
                                 half(temporary);
                                 throw 1;
                               }),
               int);
  ExpectError([&] { WriteAtomically(folder / "f", [](const auto&) {}); },
              {"/f'", "opening what was written"});
  EXPECT_EQ(ReadFile(folder / "f"), "old");
  EXPECT_EQ(folder.Entries(), 1U);
}

TEST(WriteAtomically, NamesWhereItCannotWrite) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "sub/inner");
  ExpectError([&] { WriteFile(folder / "none/f", "x"); }, {"none/f", "No such file"});
  ExpectError([&] { WriteFile(folder / "sub", "x"); }, {"sub", "rename failed"});
  ExpectError([&] { WriteFile(folder / "sub/", "x"); }, {"sub/", "does not name a file"});
  ExpectError([&] { WriteFile("/proc/warplut-test", "x"); }, {"/proc/warplut-test"});
  EXPECT_EQ(folder.Entries(), 1U);
}

TEST(ReadFile, Errors) {
  const TemporaryFolder folder;
  WriteFile(folder / "f", "12345");
  EXPECT_EQ(ReadFile(folder / "f", 5), "12345");
  ExpectError([&] { ReadFile(folder / "f", 4); }, {"/f'", "longer than 4 bytes"});
  ExpectError([&] { ReadFile(folder / "g"); }, {"/g'", "does not exist"});
  ExpectError([&] { ReadFile(folder.path()); }, {"not a regular file"});
}

TEST(CreateFolder, WithParentsAndErrors) {
  const TemporaryFolder folder;
  CreateFolder(folder / "a/b");
  CreateFolder(folder / "a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
  WriteFile(folder / "f", "x");
  ExpectError([&] { CreateFolder(folder / "f"); }, {"/f'"});
  ExpectError([&] { CreateFolder(folder / "f/g"); }, {"/f/g'"});
}

TEST(RequireWritable, LeavesNothingAndNamesWhatIsWrong) {
  const TemporaryFolder folder;
  RequireWritable(folder / "f");
  RequireWritable(folder / "a/b/f");
  RequireWritableFolder(folder / "a/b/");
  EXPECT_EQ(folder.Entries(), 0U);
  WriteFile(folder / "file", "x");
  CreateFolder(folder / "sub");
  RequireWritable(folder / "file");
  ExpectError([&] { RequireWritable(folder / "sub"); }, {"/sub'", "is a folder"});
  ExpectError([&] { RequireWritable(folder / "file/f"); }, {"/file/f'", "is not a folder"});
  ExpectError([&] { RequireWritable(folder / "file/a/b/f"); }, {"/file/a/b/f'", "/file'"});
  ExpectError([&] { RequireWritable("/proc/warplut/f"); }, {"/proc/warplut/f", "no file can be"});
  RequireWritable(folder / std::string(255, 'n'));
  ExpectError([&] { RequireWritable(folder / std::string(256, 'n')); }, {"nnn'", "too long"});
  ExpectError([&] { RequireWritableFolder("/proc/warplut"); }, {"/proc/warplut", "no file can be"});
  EXPECT_EQ(folder.Entries(), 2U);
}

}  // namespace
}  // namespace warplut
