#include "tests/fuzz/fuzz_file.h"

#include <cstdio>
#include <cstdlib>

#include "tests/datasets/temporary_folder.h"

namespace warplut {

namespace fs = std::filesystem;

const fs::path& FuzzFolder() {
  static const TemporaryFolder* const folder = [] {
    std::error_code ignored;
    if (fs::is_directory("/dev/shm", ignored)) setenv("TMPDIR", "/dev/shm", 0);
    static TemporaryFolder removed_at_exit;
    return &removed_at_exit;
  }();
  return folder->path();
}

fs::path FuzzFile(const std::string& name, std::string_view bytes) {
  const fs::path path = FuzzFolder() / name;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  Require(file.good(), "cannot write " + path.string());
  return path;
}

void Require(bool holds, const std::string& message) {
  if (holds) return;
  std::fprintf(stderr, "fault: %s\n", message.c_str());
  std::abort();
}

bool Accepts(const std::function<void()>& read) {
  try {
    read();
  } catch (const Error& refused) {
    Require(*refused.what() != '\0', "an Error without a sentence");
    return false;
  }
  return true;
}

}  // namespace warplut
