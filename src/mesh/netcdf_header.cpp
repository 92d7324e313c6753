// A reader of the netCDF classic header (format description: "NetCDF Classic Format Specification", Unidata).
#include "mesh/netcdf_header.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <vector>

#include "errors.hpp"

namespace mortise {

namespace {

struct HeaderFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

/// a b, or the greatest number where that overflows: no file is so large.
std::uint64_t saturated_product(std::uint64_t a, std::uint64_t b) { return b != 0 && a > most / b ? most : a * b; }
std::uint64_t saturated_sum(std::uint64_t a, std::uint64_t b) { return a > most - b ? most : a + b; }
std::uint64_t padded(std::uint64_t n) { return saturated_sum(n, 3) / 4 * 4; }

/// Bytes of one value of a netCDF type.
std::uint64_t type_size(std::uint64_t type) {
  constexpr std::array<std::uint64_t, 12> size{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
  if (type == 0 || type >= size.size()) throw HeaderFault(fmt::format("unknown type {}", type));
  return size[type];
}

class HeaderReader {
 public:
  HeaderReader(std::ifstream& in, std::uint64_t n_bytes, int version) : in_(in), left_(n_bytes - 4), version_(version) {}

  std::uint64_t number(int n_bytes) {
    std::array<unsigned char, 8> bytes{};
    take(static_cast<std::uint64_t>(n_bytes));
    in_.read(reinterpret_cast<char*>(bytes.data()), n_bytes);
    if (!in_) throw HeaderFault("it ends early");
    std::uint64_t value = 0;
    for (int i = 0; i < n_bytes; ++i) value = value << 8 | bytes[static_cast<std::size_t>(i)];
    return value;
  }
  std::uint64_t count() { return number(version_ == 5 ? 8 : 4); }
  std::uint64_t offset() { return number(version_ == 1 ? 4 : 8); }

  /// Number of entries of a list with the given tag (absent lists have tag 0 and no entry); every entry takes at least 8 bytes.
  std::uint64_t list(std::uint64_t tag) {
    const std::uint64_t found = number(4), n = count();
    if (found != tag && !(found == 0 && n == 0)) throw HeaderFault(fmt::format("list tag {} in place of {}", found, tag));
    if (n > left_ / 8) throw HeaderFault(fmt::format("{} entries do not fit into the file", n));
    return n;
  }
  void skip(std::uint64_t n) {
    take(n);
    in_.seekg(static_cast<std::streamoff>(n), std::ios::cur);
  }
  void skip_name() { skip(padded(count())); }
  void skip_attributes() {
    for (std::uint64_t n = list(12); n > 0; --n) {
      skip_name();
      const std::uint64_t size = type_size(number(4));
      skip(padded(saturated_product(size, count())));
    }
  }

 private:
  void take(std::uint64_t n) {
    if (n > left_) throw HeaderFault("it ends early");
    left_ -= n;
  }
  std::ifstream& in_;
  std::uint64_t left_;
  int version_;
};

/// The end of the last variable.
std::uint64_t required_size(HeaderReader& in, std::uint64_t no_count) {
  std::uint64_t n_records = in.count();
  if (n_records == no_count) n_records = 0;  // "streaming": the writer never knew
  std::vector<std::uint64_t> dimensions;
  for (std::uint64_t n = in.list(10); n > 0; --n) {
    in.skip_name();
    dimensions.push_back(in.count());
  }
  in.skip_attributes();

  struct RecordVariable {
    std::uint64_t begin, n_bytes;
  };
  std::vector<RecordVariable> record_variables;
  std::uint64_t end = 0;
  for (std::uint64_t n = in.list(11); n > 0; --n) {
    in.skip_name();
    bool is_record = false;
    std::uint64_t n_values = 1;
    const std::uint64_t rank = in.count();
    for (std::uint64_t d = 0; d < rank; ++d) {
      const std::uint64_t id = in.count();
      if (id >= dimensions.size()) throw HeaderFault(fmt::format("dimension {} of {}", id, dimensions.size()));
      if (d == 0 && dimensions[id] == 0)
        is_record = true;
      else
        n_values = saturated_product(n_values, dimensions[id]);
    }
    in.skip_attributes();
    const std::uint64_t n_bytes = saturated_product(n_values, type_size(in.number(4)));
    in.count();  // the stored size, which wraps round for large variables
    const std::uint64_t begin = in.offset();
    if (is_record)
      record_variables.push_back({begin, n_bytes});
    else
      end = std::max(end, saturated_sum(begin, n_bytes));
  }

  if (n_records > 0) {
    std::uint64_t record_size = 0;  // a single record variable is not padded
    for (const RecordVariable& v : record_variables)
      record_size = saturated_sum(record_size, record_variables.size() == 1 ? v.n_bytes : padded(v.n_bytes));
    for (const RecordVariable& v : record_variables)
      end = std::max(end, saturated_sum(saturated_sum(v.begin, saturated_product(n_records - 1, record_size)), v.n_bytes));
  }
  return end;
}

}  // namespace

NetcdfHeader read_netcdf_header(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& reason) {
    throw FileError(fmt::format("{}: error[I01] cannot be read: {}", file.string(), reason));
  };
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) refuse("it is a folder");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(std::strerror(errno));

  NetcdfHeader header;
  header.n_bytes = std::filesystem::file_size(file, status);
  if (status) refuse(status.message());
  std::array<char, 4> magic{};
  in.read(magic.data(), magic.size());
  if (!in) return header;
  if (std::memcmp(magic.data(), "\x89HDF", 4) == 0) header.kind = FileKind::hdf5;
  const int version = magic[3];
  if (std::memcmp(magic.data(), "CDF", 3) != 0 || (version != 1 && version != 2 && version != 5)) return header;

  header.kind = FileKind::classic;
  try {
    HeaderReader reader(in, header.n_bytes, version);
    header.n_required = required_size(reader, version == 5 ? most : 0xFFFFFFFFU);
  } catch (const HeaderFault& fault) {
    header.fault = fault.what();
  }
  return header;
}

}  // namespace mortise
