#include "datasets/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>

#include "datasets/error.h"
#include "datasets/temporary_file.h"

namespace warplut {
namespace {

namespace fs = std::filesystem;

// A file descriptor that is closed at the end of its scope.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags, mode_t mode = 0)
      : fd_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool ok() const { return fd_ >= 0; }
  int get() const { return fd_; }
  // Close with its result: some file systems report a full disk only here.
  bool Close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

[[noreturn]] void ThrowErrno(const char* step) {
  const int code = errno;
  throw Error(fmt::format("{} failed: {}", step, std::generic_category().message(code)));
}

void SyncFile(const fs::path& path) {
  Descriptor file(path, O_RDONLY);
  if (!file.ok()) ThrowErrno("opening what was written");
  if (::fsync(file.get()) != 0) ThrowErrno("sync");
  if (!file.Close()) ThrowErrno("close");
}

void WriteAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      ThrowErrno("write");
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void RunAtomically(const fs::path& path, const fs::path& temporary,
                   const std::function<void(const fs::path&)>& write) {
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  Descriptor folder(parent, O_RDONLY | O_DIRECTORY);
  if (!folder.ok()) ThrowErrno("opening its folder");
  write(temporary);
  SyncFile(temporary);
  if (::rename(temporary.c_str(), path.c_str()) != 0) ThrowErrno("rename");
  // Some file systems cannot sync a folder and say so with EINVAL.
  if (::fsync(folder.get()) != 0 && errno != EINVAL) ThrowErrno("sync of its folder");
}

}  // namespace

void WriteAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  if (!path.has_filename()) {
    throw Error(fmt::format("cannot write '{}': it does not name a file", path.string()));
  }
  RemoveStaleTemporaries(path.parent_path());
  const fs::path temporary = TemporaryBeside(path);
  const auto remove = [&] {
    std::error_code ignored;
    fs::remove(temporary, ignored);
  };
  try {
    RunAtomically(path, temporary, write);
  } catch (const std::exception& e) {
    remove();
    throw Error(fmt::format("cannot write '{}': {}", path.string(), e.what()));
  } catch (...) {
    remove();
    throw;
  }
}

void WriteFile(const fs::path& path, std::string_view bytes) {
  WriteAtomically(path, [&](const fs::path& temporary) {
    Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
    if (!file.ok()) ThrowErrno("creating a file beside it");
    WriteAll(file.get(), bytes);
    if (!file.Close()) ThrowErrno("close");
  });
}

std::string ReadFileStart(const fs::path& path, std::size_t bytes) {
  const auto fail = [&](const std::string& reason) {
    throw Error(fmt::format("cannot read '{}': {}", path.string(), reason));
  };
  std::error_code status_error;
  const fs::file_status status = fs::status(path, status_error);
  if (status.type() == fs::file_type::not_found) fail("it does not exist");
  if (status_error) fail(status_error.message());
  if (status.type() != fs::file_type::regular) fail("it is not a regular file");

  Descriptor file(path, O_RDONLY);
  if (!file.ok()) fail(std::generic_category().message(errno));
  std::string start;
  constexpr std::size_t kStep = std::size_t{1} << 16;
  for (std::size_t length = 0; length < bytes;) {
    const std::size_t step = std::min(kStep, bytes - length);
    start.resize(length + step);
    const ssize_t got = ::read(file.get(), start.data() + length, step);
    if (got < 0) {
      if (errno == EINTR) continue;
      fail(std::generic_category().message(errno));
    }
    length += static_cast<std::size_t>(got);
    start.resize(length);
    if (got == 0) break;
  }
  return start;
}

std::string ReadFile(const fs::path& path, std::size_t max_bytes) {
  std::string bytes = ReadFileStart(path, max_bytes + 1);
  if (bytes.size() > max_bytes) {
    throw Error(
        fmt::format("cannot read '{}': it is longer than {} bytes", path.string(), max_bytes));
  }
  return bytes;
}

bool HasExtension(const fs::path& path, std::string_view extension) {
  const std::string found = path.extension().string();
  return std::equal(
      found.begin(), found.end(), extension.begin(), extension.end(),
      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

void CreateFolder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path)) {
    throw Error(fmt::format("cannot create the folder '{}': {}", path.string(),
                            error ? error.message() : "something else has that name"));
  }
}

void RequireWritableFolder(const fs::path& folder) {
  const auto fail = [&](const std::string& reason) {
    throw Error(fmt::format("cannot write into '{}': {}", folder.string(), reason));
  };
  std::error_code error;
  fs::path existing = fs::absolute(folder).lexically_normal();
  while (!fs::exists(existing, error) && existing != existing.root_path()) {
    // A path that passes through a file is neither there nor can it be made.
    if (error && error != std::errc::no_such_file_or_directory) fail(error.message());
    existing = existing.parent_path();
  }
  if (!fs::is_directory(existing)) {
    fail(fmt::format("'{}' is not a folder", existing.string()));
  }
  RemoveStaleTemporaries(existing);
  const fs::path probe = TemporaryBeside(existing / "probe");
  const Descriptor file(probe, O_WRONLY | O_CREAT | O_EXCL, 0600);
  if (!file.ok()) {
    fail(fmt::format("no file can be made in '{}' ({})", existing.string(),
                     std::generic_category().message(errno)));
  }
  fs::remove(probe, error);
}

void RequireWritable(const fs::path& file) {
  std::error_code error;
  const bool folder = fs::is_directory(file, error);
  if (error == std::errc::filename_too_long) {
    throw Error(fmt::format("cannot write '{}': {}", file.string(), error.message()));
  }
  if (folder || !file.has_filename()) {
    throw Error(
        fmt::format("cannot write '{}': it is a folder; expected a file's name", file.string()));
  }
  try {
    RequireWritableFolder(file.has_parent_path() ? file.parent_path() : fs::path("."));
  } catch (const Error& e) {
    throw Error(fmt::format("cannot write '{}': {}", file.string(), e.what()));
  }
}

}  // namespace warplut
