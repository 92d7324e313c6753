// Files that are either the old ones or the new ones, whatever happens while they are written.
#pragma once

#include <filesystem>
#include <string>

namespace mortise {

/// Replaces `file`: the bytes go to `file`.tmp, onto the disk (fsync), under their name (rename), and the folder onto the disk
/// too. A program killed at any time, or a machine that stops, leaves the old file or the new one, never a part.
/// @throws FileError; the old file is then untouched
void write_atomically(const std::filesystem::path& file, const std::string& bytes);

/// Waits until what was written to a file is on the disk. @throws FileError
void sync_file(const std::filesystem::path& file);

}  // namespace mortise
