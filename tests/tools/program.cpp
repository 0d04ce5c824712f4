#include "tests/tools/program.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/datasets/temporary_folder.h"
#include "tests/tools/json_document.h"

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

// Whether the process handles SIGINT by now.
bool HandlesInterrupt(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("SigCgt:")) {
      return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
    }
  }
  return false;
}

// Sends SIGINT once `ready` holds, unless the process ends before.
template <class Condition>
void InterruptWhen(pid_t process, const Condition& ready) {
  siginfo_t ended = {};
  while (!ready()) {
    waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid == process) return;
    std::this_thread::sleep_for(kPoll);
  }
  kill(process, SIGINT);
}

// The JSON of a command is as docs/JSON.md has it.
void ExpectDocumented(const std::vector<std::string>& arguments, const std::string& out) {
  if (out.empty()) return;  // standard output is a file
  const std::string section = JsonSection(arguments);
  const auto page = Contents(std::filesystem::path(WARPLUT_SOURCE) / "docs/JSON.md");
  const std::vector<DocumentedKey> keys = DocumentedKeys(page, section);
  EXPECT_FALSE(keys.empty()) << "docs/JSON.md has no section " << section;
  for (const std::string& fault : JsonFaults(nlohmann::json::parse(out), keys)) {
    ADD_FAILURE() << "docs/JSON.md, " << section << ": " << fault;
  }
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
    execvp(argv[0], argv.data());
    _exit(127);
  }
  if (!setup.signal_when.empty()) {
    InterruptWhen(child, [&] { return std::filesystem::exists(setup.signal_when); });
  }
  if (setup.signal_after > 0) {
    InterruptWhen(child, [&] {
      if (!HandlesInterrupt(child)) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(setup.signal_after));
      return true;
    });
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = setup.standard_output.empty() ? Contents(out) : std::string(),
          .err = Contents(folder / "err")};
}

ProgramResult RunWarplut(const std::vector<std::string>& arguments, const ProgramSetup& setup) {
  ProgramResult result = RunProgram(WARPLUT_PROGRAM, arguments, setup);
  const bool asks = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
  if (asks && (result.code == 0 || result.code == kMissed)) ExpectDocumented(arguments, result.out);
  return result;
}

std::vector<std::string> WithDefaults(
    std::vector<std::string> command,
    const std::vector<std::pair<std::string, std::string>>& defaults,
    const std::vector<std::string>& more) {
  for (const auto& [option, value] : defaults) {
    if (std::find(more.begin(), more.end(), option) != more.end()) continue;
    command.insert(command.end(), {option, value});
  }
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

void ExpectRefused(const ProgramResult& result, int code, const std::string& piece) {
  // libpng tells standard error about a damaged file before it returns; that line is not ours.
  std::istringstream lines(result.err);
  std::string sentences;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("libpng ")) sentences += line + "\n";
  }
  EXPECT_EQ(result.code, code) << result.err;
  EXPECT_THAT(sentences, testing::StartsWith("warplut: "));
  EXPECT_THAT(sentences, testing::EndsWith(".\n"));
  EXPECT_EQ(sentences.find('\n'), sentences.size() - 1) << result.err;
  EXPECT_THAT(sentences, testing::HasSubstr(piece));
}

}  // namespace warplut
