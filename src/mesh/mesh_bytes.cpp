// A mesh as bytes: each struct names its members once, for both directions.
#include "mesh/mesh_bytes.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace mortise {

namespace {

class Packer {
 public:
  explicit Packer(std::size_t expected_size) { bytes_.reserve(expected_size); }
  template <class Number>
  void number(Number& n) {
    bytes_.append(reinterpret_cast<const char*>(&n), sizeof n);
  }
  /// A string, or a vector of what can be copied byte by byte.
  template <class List>
  void plain(List& list) {
    static_assert(std::is_trivially_copyable_v<typename List::value_type>);
    std::size_t n = list.size();
    number(n);
    bytes_.append(reinterpret_cast<const char*>(list.data()), n * sizeof(typename List::value_type));
  }
  template <class Entity>
  void entities(std::vector<Entity>& list) {
    std::size_t n = list.size();
    number(n);
    for (Entity& entity : list) members(*this, entity);
  }
  std::string bytes() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Unpacker {
 public:
  explicit Unpacker(const std::string& bytes) : bytes_(bytes) {}

  template <class Number>
  void number(Number& n) {
    copy(&n, 1);
  }
  template <class List>
  void plain(List& list) {
    std::size_t n = 0;
    number(n);
    require(n <= (bytes_.size() - at_) / sizeof(typename List::value_type));
    list.resize(n);
    copy(list.data(), n);
  }
  template <class Entity>
  void entities(std::vector<Entity>& list) {
    std::size_t n = 0;
    number(n);
    require(n <= bytes_.size() - at_);
    list.resize(n);
    for (Entity& entity : list) members(*this, entity);
  }
  void finish() const { require(at_ == bytes_.size()); }

 private:
  static void require(bool holds) {
    if (!holds) throw std::logic_error("bytes that are no mesh");
  }
  template <class T>
  void copy(T* to, std::size_t n) {
    require(n * sizeof(T) <= bytes_.size() - at_);
    if (n > 0) std::memcpy(to, bytes_.data() + at_, n * sizeof(T));
    at_ += n * sizeof(T);
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
};

template <class Archive>
void members(Archive& archive, Block& block) {
  archive.number(block.id);
  archive.plain(block.name);
  ElementType type = block.elements.type();
  archive.number(type);
  if (type != block.elements.type()) block.elements = ElementList(type);
  archive.plain(block.elements.nodes());
}

template <class Archive>
void members(Archive& archive, SideSet& set) {
  archive.number(set.id);
  archive.plain(set.name);
  archive.plain(set.sides);
}

template <class Archive>
void members(Archive& archive, NodeSet& set) {
  archive.number(set.id);
  archive.plain(set.name);
  archive.plain(set.nodes);
}

template <class Archive>
void members(Archive& archive, Mesh& mesh) {
  archive.plain(mesh.source);
  archive.plain(mesh.coordinates);
  archive.plain(mesh.node_numbers);
  archive.plain(mesh.element_numbers);
  archive.entities(mesh.blocks);
  archive.entities(mesh.side_sets);
  archive.entities(mesh.node_sets);
}

template <class Archive>
void members(Archive& archive, MeshVariable& variable) {
  archive.plain(variable.name);
  archive.plain(variable.values);
}

template <class Archive>
void members(Archive& archive, MeshFrame& frame) {
  members(archive, frame.mesh);
  archive.number(frame.time);
  archive.entities(frame.nodal);
  archive.entities(frame.global);
}

template <class Content>
Content unpacked(const std::string& bytes) {
  Unpacker unpacker(bytes);
  Content content;
  members(unpacker, content);
  unpacker.finish();
  return content;
}

std::size_t expected_size(const Mesh& mesh) {
  // Nearly all of it is nodes and elements; sets find room in the rest.
  const std::size_t n = mesh.coordinates.size() * (sizeof(Point) + sizeof(std::int64_t)) +
                        mesh.element_numbers.size() * (8 * sizeof(int) + sizeof(std::int64_t));
  return n + n / 8;
}

template <class Content>
std::string packed(const Content& content, std::size_t expected_size) {
  Packer packer(expected_size);
  members(packer, const_cast<Content&>(content));  // the packer only reads
  return std::move(packer).bytes();
}

}  // namespace

std::string bytes_of(const Mesh& mesh) { return packed(mesh, expected_size(mesh)); }

std::string bytes_of(const MeshFrame& frame) {
  std::size_t n = expected_size(frame.mesh);
  for (const MeshVariable& variable : frame.nodal) n += variable.values.size() * sizeof(double);
  return packed(frame, n);
}

Mesh mesh_of(const std::string& bytes) { return unpacked<Mesh>(bytes); }
MeshFrame frame_of(const std::string& bytes) { return unpacked<MeshFrame>(bytes); }

}  // namespace mortise
