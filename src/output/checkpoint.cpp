#include "output/checkpoint.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/atomic_file.hpp"

namespace mortise {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::string_view first_line = "mortise checkpoint, format 5\n";
constexpr std::string_view any_first_line = "mortise checkpoint, format ";
constexpr std::string_view file_stem = "checkpoint.";

// Numbers as the bytes of the machine (little-endian, as on every machine that Debian's Trilinos is built for): exact and short.
template <class T>
Json blob(const std::vector<T>& values) {
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return Json::binary(std::move(bytes));
}

template <class T>
std::vector<T> numbers(const Json& blob) {
  const auto& bytes = blob.get_binary();
  if (bytes.size() % sizeof(T) != 0) throw std::invalid_argument("a list of numbers is cut");
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

/// One place for each struct: writing and reading go through the same list of members.
struct Writer {
  Json& json;
  template <class T>
  void operator()(const char* name, const T& value) const {
    json[name] = value;
  }
  template <class T>
  void list(const char* name, const std::vector<T>& values) const {
    json[name] = blob(values);
  }
};
struct Reader {
  const Json& json;
  template <class T>
  void operator()(const char* name, T& value) const {
    json.at(name).get_to(value);
  }
  template <class T>
  void list(const char* name, std::vector<T>& values) const {
    values = numbers<T>(json.at(name));
  }
};

template <class Visit, class C>
void members(const Visit& visit, C& c) {
  visit("program", c.origin.program);
  visit("deck file", c.origin.deck_file);
  visit("deck text", c.origin.deck_text);
  visit("meshes", c.origin.meshes);
  visit("time", c.time);
  visit("dt", c.dt);
  visit("stage", c.stage);
  visit("enters stage", c.enters_stage);
  visit("pending cuts", c.pending_cuts);
  visit("closed nodes", c.n_closed);
  visit("steps", c.done.steps);
  visit("cuts", c.done.cuts);
  visit("newton iterations", c.done.newton_iterations);
  visit("wasted iterations", c.done.wasted_iterations);
  visit("frames", c.frames);
  visit.list("x", c.x);
  visit.list("v", c.v);
  visit.list("a", c.a);
  visit.list("search x", c.search_x);
  visit("search reach", c.search_reach);
  visit("search inward", c.search_inward);
  visit("external work", c.ledger.external);
  visit("contact work", c.ledger.contact);
  visit("closing work", c.ledger.closing);
  visit("resegmentation work", c.ledger.resegmentation);
  visit("damping dissipation", c.ledger.damping);
  visit("algorithmic dissipation", c.ledger.algorithmic);
  visit("residual work", c.ledger.residual);
  visit("mismatch", c.ledger.mismatch);
  visit("strain energy", c.ledger.strain_energy);
  visit("kinetic energy", c.ledger.kinetic_energy);
  visit("stick energy", c.ledger.stick_energy);
  visit("friction dissipation", c.ledger.friction);
  visit.list("linear momentum", c.ledger.linear_momentum);
  visit.list("angular momentum", c.ledger.angular_momentum);
  visit.list("linear balance", c.ledger.linear_balance);
  visit.list("angular balance", c.ledger.angular_balance);
  visit.list("closed", c.ledger.closed);
  visit.list("weighted gap", c.ledger.weighted_gap);
  visit("evaluations", c.work.evaluations);
  visit("tangents", c.work.tangents);
  visit("element tangents", c.work.element_tangents);
  visit("graphs", c.work.graphs);
  visit("seconds search", c.work.seconds_search);
  visit("seconds contact", c.work.seconds_contact);
  visit("seconds elements", c.work.seconds_elements);
  visit("seconds assembly", c.work.seconds_assembly);
}

std::string four_bytes(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xFF);
  return bytes;
}

std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

int step_of(const fs::path& file) {
  const std::string name = file.filename().string();
  int step = -1;
  if (name.rfind(file_stem, 0) != 0) return -1;
  const char* end = name.data() + name.size();
  const auto [stop, status] = std::from_chars(name.data() + file_stem.size(), end, step);
  return status == std::errc() && stop == end ? step : -1;
}

}  // namespace

Checkpoint make_checkpoint(const Origin& origin, const StepProblem& problem, const MarchState& at, const Ledger& ledger,
                           int frames) {
  Checkpoint c;
  c.origin = origin;
  c.time = at.state.time;
  c.dt = at.dt;
  c.stage = at.stage;
  c.enters_stage = at.enters_stage;
  c.pending_cuts = at.pending_cuts;
  c.n_closed = at.n_closed;
  c.done = at.counts;
  c.frames = frames;
  c.x = problem.gather(*at.state.x);
  if (!at.state.v.is_null()) {
    c.v = problem.gather(*at.state.v);
    c.a = problem.gather(*at.state.a);
  }
  if (!at.state.search.x.is_null()) c.search_x = problem.gather(*at.state.search.x);
  c.search_reach = at.state.search.reach;
  c.search_inward = at.state.search.inward;
  c.ledger = ledger;
  c.work = problem.counts();
  for (const auto& pair : problem.pairs()) c.contact.push_back(pair->counts());
  return c;
}

MarchState resume(const Checkpoint& c, StepProblem& problem) {
  MarchState at;
  at.state.time = c.time;
  at.state.x = problem.scatter(c.x);
  if (!c.v.empty()) {
    at.state.v = problem.scatter(c.v);
    at.state.a = problem.scatter(c.a);
  }
  if (!c.search_x.empty()) at.state.search = {problem.scatter(c.search_x), c.search_reach, c.search_inward};
  at.dt = c.dt;
  at.stage = c.stage;
  at.enters_stage = c.enters_stage;
  at.pending_cuts = c.pending_cuts;
  at.n_closed = c.n_closed;
  at.counts = c.done;
  problem.set_stage(static_cast<std::size_t>(std::max(c.stage, 0)));
  problem.begin_step(at.state, c.time);  // repeats the search
  problem.resume_counts(c.work, c.contact);
  return at;
}

std::string to_bytes(const Checkpoint& c) {
  Json json;
  members(Writer{json}, c);
  json["contact"] = Json::array();
  for (const auto& pair : c.contact) json["contact"].push_back({pair.searches, pair.pairs, pair.overlaps, pair.turned_away});
  std::string data;
  Json::to_cbor(json, data);
  std::string bytes(first_line);
  const std::uint64_t length = data.size();
  bytes += four_bytes(static_cast<std::uint32_t>(length >> 32)) + four_bytes(static_cast<std::uint32_t>(length));
  bytes += four_bytes(crc_of(data));
  return bytes + data;
}

Checkpoint from_bytes(std::string_view bytes) {
  if (bytes.substr(0, any_first_line.size()) != any_first_line) throw std::invalid_argument("is no checkpoint");
  if (bytes.substr(0, first_line.size()) != first_line)
    throw std::invalid_argument("has a format of another version of the program");
  bytes.remove_prefix(first_line.size());
  const auto number = [&](std::size_t at, std::size_t n) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < n; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
    return value;
  };
  if (bytes.size() < 12) throw std::invalid_argument("is cut short");
  const std::uint64_t length = number(0, 8), crc = number(8, 4);
  bytes.remove_prefix(12);
  if (bytes.size() != length)
    throw std::invalid_argument(fmt::format("holds {} bytes of data in place of {}", bytes.size(), length));
  if (crc_of(bytes) != crc) throw std::invalid_argument("is damaged (its CRC-32 does not match)");
  Checkpoint c;
  try {
    const Json json = Json::from_cbor(bytes);
    members(Reader{json}, c);
    for (const Json& pair : json.at("contact")) c.contact.push_back({pair.at(0), pair.at(1), pair.at(2), pair.at(3)});
  } catch (const Json::exception& fault) {
    throw std::invalid_argument(std::string("cannot be understood: ") + fault.what());
  }
  return c;
}

void write_checkpoint(const fs::path& folder, const Checkpoint& checkpoint) {
  write_atomically(folder / fmt::format("{}{}", file_stem, checkpoint.done.steps), to_bytes(checkpoint));
  const auto files = checkpoint_files(folder);
  std::error_code ignored;  // what cannot be removed does no harm
  for (std::size_t k = 2; k < files.size(); ++k) fs::remove(files[k], ignored);
}

std::vector<fs::path> checkpoint_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (step_of(entry.path()) >= 0) files.push_back(entry.path());
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return step_of(a) > step_of(b); });
  return files;
}

Checkpoint read_newest_checkpoint(const fs::path& folder, std::vector<std::string>& warnings) {
  std::vector<std::string> reasons;
  for (const auto& file : checkpoint_files(folder)) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    try {
      if (!in) throw std::invalid_argument("cannot be read");
      const Checkpoint checkpoint = from_bytes(bytes);
      for (const auto& reason : reasons) warnings.push_back(reason + "; the one before is taken");
      return checkpoint;
    } catch (const std::invalid_argument& fault) {
      reasons.push_back(fmt::format("{}: error[I10] {}", file.string(), fault.what()));
    }
  }
  if (!reasons.empty()) throw FileError(fmt::format("{}", fmt::join(reasons, "\n")));
  throw FileError(
      fmt::format("{}: error[I10] holds no checkpoint - a folder that `mortise run` wrote is needed", folder.string()));
}

}  // namespace mortise
