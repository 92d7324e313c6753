#include "output/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "errors.hpp"

namespace mortise {
namespace {

/// An open file that closes itself; every failure is a FileError with the system's reason.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& file, int flags) : file_(file), id_(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    require(id_ >= 0);
  }
  ~Descriptor() {
    if (id_ >= 0) ::close(id_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(const std::string& bytes) {
    for (std::size_t done = 0; done < bytes.size();) {
      const auto n = ::write(id_, bytes.data() + done, bytes.size() - done);
      if (n < 0 && errno == EINTR) continue;
      require(n >= 0);
      done += static_cast<std::size_t>(n);
    }
  }
  // Some file systems cannot be told (EINVAL): then there is nothing to wait for.
  void sync() { require(::fsync(id_) == 0 || errno == EINVAL); }

 private:
  void require(bool good) const {
    if (!good) throw FileError(fmt::format("{}: error[I02] cannot be written: {}", file_.string(), std::strerror(errno)));
  }
  std::filesystem::path file_;
  int id_;
};

}  // namespace

void write_atomically(const std::filesystem::path& file, const std::string& bytes) {
  const std::filesystem::path fresh = file.string() + ".tmp";
  try {
    Descriptor out(fresh, O_WRONLY | O_CREAT | O_TRUNC);
    out.write(bytes);
    out.sync();
  } catch (const FileError&) {
    std::error_code ignored;
    std::filesystem::remove(fresh, ignored);  // half a file on a full disk helps nobody
    throw;
  }
  std::error_code failure;
  std::filesystem::rename(fresh, file, failure);
  if (failure) throw FileError(fmt::format("{}: error[I02] cannot be written: {}", file.string(), failure.message()));
  const auto folder = file.parent_path();
  Descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY).sync();
}

void sync_file(const std::filesystem::path& file) { Descriptor(file, O_RDONLY).sync(); }

}  // namespace mortise
