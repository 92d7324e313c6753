// Reading the numbers of a file header, never beyond the bytes that the file has.
#pragma once

#include <cstdint>
#include <istream>
#include <stdexcept>
#include <string>

namespace mortise {

/// What is wrong with a header, in words that complete "the header is broken: ...".
struct HeaderFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a stream from its beginning. Every member that would go beyond the end throws HeaderFault and reads nothing.
class ByteReader {
 public:
  ByteReader(std::istream& in, std::uint64_t n_bytes) : in_(in), n_bytes_(n_bytes) {}

  std::uint64_t position() const { return position_; }
  std::uint64_t left() const { return n_bytes_ - position_; }

  /// An unsigned number of at most 8 bytes.
  std::uint64_t big_endian(std::size_t n) {
    std::uint64_t value = 0;
    for (unsigned char byte : bytes(n)) value = value << 8 | byte;
    return value;
  }
  std::uint64_t little_endian(std::size_t n) {
    std::uint64_t value = 0, scale = 1;
    for (unsigned char byte : bytes(n)) {
      value += byte * scale;
      scale <<= 8;
    }
    return value;
  }
  std::string bytes(std::size_t n) {
    take(n);
    std::string text(n, '\0');
    if (!in_.read(text.data(), static_cast<std::streamsize>(n))) throw HeaderFault("it ends early");
    return text;
  }
  void skip(std::uint64_t n) {
    take(n);
    in_.seekg(static_cast<std::streamoff>(n), std::ios::cur);
  }

 private:
  void take(std::uint64_t n) {
    if (n > left()) throw HeaderFault("it ends early");
    position_ += n;
  }
  std::istream& in_;
  std::uint64_t n_bytes_;
  std::uint64_t position_ = 0;
};

}  // namespace mortise
