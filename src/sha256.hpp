// SHA-256 of texts and files, in hexadecimal.
#pragma once

#include <filesystem>
#include <string>

namespace mortise {

/// SHA-256 of a text: 64 hexadecimal digits in lower case.
std::string sha256(const std::string& text);

/// SHA-256 of a file's bytes. @throws FileError
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace mortise
