#include "tests/tools/program.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/datasets/temporary_folder.h"

namespace warplut {
namespace {

constexpr std::chrono::milliseconds kPoll{5};

std::string Contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

void Redirect(const std::filesystem::path& path, int descriptor) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(127);
}

}  // namespace

ProgramResult RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                         const ProgramSetup& setup) {
  const TemporaryFolder folder;
  const std::filesystem::path out =
      setup.standard_output.empty() ? folder / "out" : std::filesystem::path(setup.standard_output);
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child == 0) {
    Redirect(out, STDOUT_FILENO);
    Redirect(folder / "err", STDERR_FILENO);
    if (setup.file_size_limit > 0) {
      const auto bytes = static_cast<rlim_t>(setup.file_size_limit);
      const rlimit limit = {.rlim_cur = bytes, .rlim_max = bytes};
      setrlimit(RLIMIT_FSIZE, &limit);
    }
    execv(argv[0], argv.data());
    _exit(127);
  }
  int status = 0;
  if (!setup.signal_when.empty()) {
    while (!std::filesystem::exists(setup.signal_when) && waitpid(child, &status, WNOHANG) == 0) {
      std::this_thread::sleep_for(kPoll);
    }
    kill(child, SIGINT);
  }
  waitpid(child, &status, 0);
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = setup.standard_output.empty() ? Contents(out) : std::string(),
          .err = Contents(folder / "err")};
}

ProgramResult RunWarplut(const std::vector<std::string>& arguments, const ProgramSetup& setup) {
  return RunProgram(WARPLUT_PROGRAM, arguments, setup);
}

void ExpectRefused(const ProgramResult& result, int code, const std::string& piece) {
  EXPECT_EQ(result.code, code) << result.err;
  EXPECT_THAT(result.err, testing::StartsWith("warplut: "));
  EXPECT_THAT(result.err, testing::EndsWith(".\n"));
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_THAT(result.err, testing::HasSubstr(piece));
}

}  // namespace warplut
