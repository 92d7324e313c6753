// SHA-256 of texts and files, by OpenSSL.
#include "sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <fstream>
#include <memory>
#include <vector>

#include "errors.hpp"

namespace mortise {

namespace {

class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) { EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr); }
  void add(const char* bytes, std::size_t n) { EVP_DigestUpdate(context_.get(), bytes, n); }
  std::string hexadecimal() {
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int length = 0;
    EVP_DigestFinal_ex(context_.get(), digest, &length);
    std::string hex;
    for (unsigned int k = 0; k < length; ++k) hex += fmt::format("{:02x}", digest[k]);
    return hex;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

}  // namespace

std::string sha256(const std::string& text) {
  Digest digest;
  digest.add(text.data(), text.size());
  return digest.hexadecimal();
}

std::string sha256_of_file(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& reason) {
    throw FileError(fmt::format("{}: error[I01] cannot be read{}", file.string(), reason));
  };
  std::error_code status;
  if (!std::filesystem::is_regular_file(file, status)) refuse(status ? ": " + status.message() : ": it is no regular file");
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse("");
  Digest digest;
  std::vector<char> buffer(1 << 20);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || in.gcount() > 0)
    digest.add(buffer.data(), static_cast<std::size_t>(in.gcount()));
  if (in.bad()) refuse("");
  return digest.hexadecimal();
}

}  // namespace mortise
