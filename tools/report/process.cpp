#include "tools/report/process.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "datasets/error.h"

namespace warplut {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
// Files without a name: unlike pipes they hold any amount, so that no side has to wait for the
// other.
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

TemporaryFile MakeTemporaryFile(const std::string& program) {
  TemporaryFile file(std::tmpfile());
  if (!file) {
    throw Error("no temporary file could be made for " + program + ": " + std::strerror(errno));
  }
  return file;
}

std::string Contents(std::FILE* file) {
  std::string bytes;
  char part[1 << 14];
  std::rewind(file);
  for (std::size_t count; (count = std::fread(part, 1, sizeof part, file)) > 0;) {
    bytes.append(part, count);
  }
  return bytes;
}

}  // namespace

ProcessResult RunProcess(const std::vector<std::string>& arguments, std::string_view input) {
  const std::string& program = arguments.front();
  const TemporaryFile in = MakeTemporaryFile(program), out = MakeTemporaryFile(program),
                      err = MakeTemporaryFile(program);
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() ||
      std::fflush(in.get()) != 0) {
    throw Error("the input of " + program + " could not be written: " + std::strerror(errno));
  }
  std::rewind(in.get());
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(err.get()), STDERR_FILENO);
  pid_t child = 0;
  const int failure =
      posix_spawnp(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == ENOENT) return {};
  if (failure != 0) throw Error(program + " could not be started: " + std::strerror(failure));

  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw Error(program + " could not be waited for: " + std::strerror(errno));
  }
  return {.found = true,
          .code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = Contents(out.get()),
          .err = Contents(err.get())};
}

}  // namespace warplut
