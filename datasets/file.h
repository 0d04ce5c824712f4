// Files that are never half written.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace warplut {

// Calls `write` with the path of a temporary file beside `path` (same extension), then syncs that
// file, renames it to `path` and syncs the folder. On any failure the temporary file is removed,
// `path` is as it was, and an Error names `path` and the reason; if only the last sync fails, that
// of the folder, there is an Error although `path` is the new file, complete. Parent folders must
// exist.
void WriteAtomically(const std::filesystem::path& path,
                     const std::function<void(const std::filesystem::path& temporary)>& write);

// WriteAtomically of these bytes.
void WriteFile(const std::filesystem::path& path, std::string_view bytes);

// The bytes of a regular file. An Error names `path` if it is missing, unreadable or longer than
// `max_bytes`.
std::string ReadFile(const std::filesystem::path& path,
                     std::size_t max_bytes = std::size_t{1} << 30);

// The first `bytes` bytes of a regular file, fewer if it is shorter. Errors as ReadFile.
std::string ReadFileStart(const std::filesystem::path& path, std::size_t bytes);

// Whether the name of `path` ends with `extension` (lower case, with its dot), in any case.
bool HasExtension(const std::filesystem::path& path, std::string_view extension);

// Creates the folder and its parents; an Error names what could not be created.
void CreateFolder(const std::filesystem::path& path);

// Whether `file` could be written, once CreateFolder made its folder: for long work, before it
// begins. An Error names `file` if it is a folder, if something that is no folder is in its path,
// or if the folder (of those that exist, the nearest above it) takes no new file. Leaves nothing
// behind.
void RequireWritable(const std::filesystem::path& file);

// The same of files in `folder`.
void RequireWritableFolder(const std::filesystem::path& folder);

}  // namespace warplut
