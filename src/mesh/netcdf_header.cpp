// A reader of the netCDF classic header (format description: "NetCDF Classic Format Specification", Unidata).
#include "mesh/netcdf_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

#include "errors.hpp"
#include "mesh/byte_reader.hpp"
#include "mesh/hdf5_superblock.hpp"

namespace mortise {

namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t longest_name = 256;   // NC_MAX_NAME
constexpr std::uint64_t highest_rank = 1024;  // NC_MAX_VAR_DIMS

/// a b, or the greatest number where that overflows: no file is so large.
std::uint64_t saturated_product(std::uint64_t a, std::uint64_t b) { return b != 0 && a > most / b ? most : a * b; }
std::uint64_t saturated_sum(std::uint64_t a, std::uint64_t b) { return a > most - b ? most : a + b; }
std::uint64_t padded(std::uint64_t n) { return saturated_sum(n, 3) / 4 * 4; }

/// Where the data of a variable lie. Of a record variable: those of the first record.
struct Variable {
  std::string name;
  bool is_record = false;
  std::uint64_t n_bytes = 0;      ///< without padding
  std::uint64_t stored_size = 0;  ///< what the header says itself
  std::uint64_t begin = 0;
};

/// Reads the header part by part, in the order of the file.
class HeaderReader {
 public:
  HeaderReader(ByteReader& in, int version) : in_(in), version_(version) {}

  std::uint64_t number_of_records() {
    const std::uint64_t n = count();
    if (n == (version_ == 5 ? most : 0xFFFFFFFFU)) throw HeaderFault("the number of records is left open");
    return n;
  }

  std::vector<std::uint64_t> dimensions() {
    std::vector<std::uint64_t> sizes;
    for (std::uint64_t n = list(10); n > 0; --n) {
      const std::string dimension = name();
      sizes.push_back(count());
      if (sizes.back() > (version_ == 5 ? most / 2 : 0x7FFFFFFFU))
        throw HeaderFault(fmt::format("dimension \"{}\" is negative", dimension));
    }
    if (std::count(sizes.begin(), sizes.end(), 0U) > 1) throw HeaderFault("more than one record dimension");
    return sizes;
  }

  void attributes() {
    for (std::uint64_t n = list(12); n > 0; --n) {
      name();
      const std::uint64_t size = type_size();
      in_.skip(padded(saturated_product(size, count())));
    }
  }

  std::vector<Variable> variables(const std::vector<std::uint64_t>& dimensions) {
    std::vector<Variable> all;
    for (std::uint64_t n = list(11); n > 0; --n) all.push_back(variable(dimensions));
    return all;
  }

 private:
  std::uint64_t count() { return in_.big_endian(version_ == 5 ? 8 : 4); }

  /// Number of entries of a list with the given tag (absent lists have tag 0 and no entry); every entry takes at least 8 bytes.
  std::uint64_t list(std::uint64_t tag) {
    const std::uint64_t found = in_.big_endian(4), n = count();
    if (found != tag && !(found == 0 && n == 0)) throw HeaderFault(fmt::format("list tag {} in place of {}", found, tag));
    if (n > in_.left() / 8) throw HeaderFault(fmt::format("{} entries do not fit into the file", n));
    return n;
  }

  std::string name() {
    const std::uint64_t n = count();
    if (n == 0 || n > longest_name) throw HeaderFault(fmt::format("a name of {} bytes - 1 to {}", n, longest_name));
    const std::string text = in_.bytes(n);
    if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return c < 32 || c == 127 || c == '/'; }))
      throw HeaderFault("a name with a control character or a slash");
    in_.skip(padded(n) - n);
    return text;
  }

  /// Bytes of one value of the type that stands next.
  std::uint64_t type_size() {
    constexpr std::array<std::uint64_t, 12> size{0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    const std::uint64_t type = in_.big_endian(4);
    if (type < 1 || type > (version_ == 5 ? 11 : 6)) throw HeaderFault(fmt::format("unknown type {}", type));
    return size[type];
  }

  Variable variable(const std::vector<std::uint64_t>& dimensions) {
    Variable v;
    v.name = name();
    const std::uint64_t rank = count();
    if (rank > highest_rank) throw HeaderFault(fmt::format("\"{}\" has {} dimensions - at most {}", v.name, rank, highest_rank));
    v.n_bytes = 1;
    for (std::uint64_t d = 0; d < rank; ++d) {
      const std::uint64_t id = count();
      if (id >= dimensions.size()) throw HeaderFault(fmt::format("\"{}\": dimension {} of {}", v.name, id, dimensions.size()));
      if (dimensions[id] > 0) {
        v.n_bytes = saturated_product(v.n_bytes, dimensions[id]);
      } else if (d == 0) {
        v.is_record = true;
      } else {
        throw HeaderFault(fmt::format("\"{}\": the record dimension is not the first", v.name));
      }
    }
    attributes();
    v.n_bytes = saturated_product(v.n_bytes, type_size());
    v.stored_size = count();
    v.begin = in_.big_endian(version_ == 1 ? 4 : 8);
    return v;
  }

  ByteReader& in_;
  int version_;
};

/// Bytes that a variable takes in the file, or in a record: padded, but for a single record variable.
std::uint64_t room(const Variable& v, bool is_alone) { return is_alone ? v.n_bytes : padded(v.n_bytes); }

/// The stored size must agree with dimensions and type, except of variables that are too large for it in the older formats.
void check_stored_size(const Variable& v, bool is_alone) {
  constexpr std::uint64_t largest = 0xFFFFFFFCU;
  if (padded(v.n_bytes) > largest || v.stored_size == padded(v.n_bytes) || v.stored_size == room(v, is_alone)) return;
  throw HeaderFault(
      fmt::format("\"{}\" has {} bytes by its dimensions and {} by its size", v.name, padded(v.n_bytes), v.stored_size));
}

/// The end of the data, as the netCDF library computes it when it closes a file. Fixed variables may have gaps between them, the
/// variables of a record have none.
std::uint64_t end_of_data(std::vector<Variable> variables, std::uint64_t n_records, std::uint64_t header_end) {
  std::sort(variables.begin(), variables.end(), [](const Variable& a, const Variable& b) { return a.begin < b.begin; });
  const auto first_record =
      std::stable_partition(variables.begin(), variables.end(), [](const Variable& v) { return !v.is_record; });
  std::uint64_t end = header_end;
  for (auto v = variables.begin(); v != first_record; ++v) {
    check_stored_size(*v, false);
    if (v->begin < end) throw HeaderFault(fmt::format("\"{}\" begins at {}, inside of what ends at {}", v->name, v->begin, end));
    end = saturated_sum(v->begin, room(*v, false));
  }
  if (first_record == variables.end()) return end;

  const bool is_alone = variables.end() - first_record == 1;
  const std::uint64_t begin = first_record->begin;
  if (begin < end)
    throw HeaderFault(fmt::format("\"{}\" begins at {}, inside of what ends at {}", first_record->name, begin, end));
  std::uint64_t record_end = begin;
  for (auto v = first_record; v != variables.end(); ++v) {
    check_stored_size(*v, is_alone);
    if (v->begin != record_end)
      throw HeaderFault(fmt::format("\"{}\" begins at {}, its place in the record is {}", v->name, v->begin, record_end));
    record_end = saturated_sum(record_end, room(*v, is_alone));
  }
  return saturated_sum(begin, saturated_product(n_records, record_end - begin));
}

std::uint64_t classic_size(ByteReader& in, int version) {
  HeaderReader header(in, version);
  const std::uint64_t n_records = header.number_of_records();
  const std::vector<std::uint64_t> dimensions = header.dimensions();
  header.attributes();
  const std::vector<Variable> variables = header.variables(dimensions);
  return end_of_data(variables, n_records, in.position());
}

}  // namespace

NetcdfHeader parse_netcdf_header(std::istream& in, std::uint64_t n_bytes) {
  NetcdfHeader header;
  header.n_bytes = n_bytes;
  std::array<char, 4> magic{};
  if (!in.read(magic.data(), magic.size())) return header;
  const int version = magic[3];
  const bool is_hdf5 = std::memcmp(magic.data(), "\x89HDF", 4) == 0;
  const bool is_classic = std::memcmp(magic.data(), "CDF", 3) == 0 && (version == 1 || version == 2 || version == 5);
  if (!is_hdf5 && !is_classic) return header;

  header.kind = is_hdf5 ? FileKind::hdf5 : FileKind::classic;
  try {
    in.seekg(0);
    ByteReader reader(in, n_bytes);
    if (is_classic) reader.skip(magic.size());
    header.n_required = is_hdf5 ? hdf5_end_of_file(reader) : classic_size(reader, version);
  } catch (const HeaderFault& fault) {
    header.fault = fault.what();
  }
  return header;
}

NetcdfHeader read_netcdf_header(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& reason) {
    throw FileError(fmt::format("{}: error[I01] cannot be read: {}", file.string(), reason));
  };
  std::error_code status;
  if (std::filesystem::is_directory(file, status)) refuse("it is a folder");
  if (std::filesystem::exists(file, status) && !std::filesystem::is_regular_file(file, status)) refuse("it is no regular file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(std::strerror(errno));
  const auto n_bytes = std::filesystem::file_size(file, status);
  if (status) refuse(status.message());
  return parse_netcdf_header(in, n_bytes);
}

}  // namespace mortise
