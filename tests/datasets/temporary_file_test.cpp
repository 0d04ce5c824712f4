#include "datasets/temporary_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "datasets/file.h"
#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// The name that a process which has ended had for its file.
fs::path NameOfDeadProcess(const fs::path& path) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  int status = 0;
  waitpid(child, &status, 0);
  std::string name = TemporaryBeside(path).string();
  const std::string own = fmt::format("-{}-", getpid());
  const std::size_t at = name.rfind(own);
  EXPECT_NE(at, std::string::npos) << name;
  return name.replace(at, own.size(), fmt::format("-{}-", child));
}

TEST(TemporaryFile, OfADeadProcessIsRemovedByTheNextWrite) {
  const TemporaryFolder folder;
  WriteFile(NameOfDeadProcess(folder / "frame.png"), "half");
  RemoveStaleTemporaries(folder / "not there");
  // The folder was looked into by that write; another spelling of it is a new one.
  WriteFile(folder.path() / "." / "other.json", "{}");
  EXPECT_EQ(folder.Entries(), 1U);
  EXPECT_TRUE(fs::exists(folder / "other.json"));
}

TEST(TemporaryFile, OfALivingProcessAndOtherHiddenFilesStay) {
  const TemporaryFolder folder;
  const fs::path living = TemporaryBeside(folder / "frame.png");
  const fs::path dead = NameOfDeadProcess(folder / "frame.png");
  std::string elsewhere = dead.string();
  const std::size_t machine = elsewhere.find("frame.") + 6;
  elsewhere.replace(machine, 8, elsewhere[machine] == '0' ? "11111111" : "00000000");
  const fs::path others[] = {living,
                             fs::path(elsewhere),
                             folder / ".tmp",
                             folder / ".frame.tmp.png",
                             folder / ".frame.1-2.tmp.png",
                             folder / "frame.tmp.png"};
  const TemporaryFolder source;
  WriteFile(source / "file", "x");
  for (const fs::path& other : others) fs::copy_file(source / "file", other);
  fs::copy_file(source / "file", dead);
  RemoveStaleTemporaries(folder.path());
  EXPECT_FALSE(fs::exists(dead));
  for (const fs::path& other : others) EXPECT_TRUE(fs::exists(other)) << other;
}

}  // namespace
}  // namespace warplut
