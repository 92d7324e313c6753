// The Exodus results of a run: geometry once, then one frame per output time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

/// Variables of elements, and which blocks of the mesh have them.
struct ElementVariables {
  std::vector<std::string> names;
  std::vector<int> in_block;  ///< per block its row of 1 (has the variable) and 0: the truth table of Exodus
};

/// The variables of a file, by name.
struct ResultsVariables {
  std::vector<std::string> nodal;  ///< e.g. "displacement_x" (ParaView joins _x _y _z to a vector)
  std::vector<std::string> global;
  ElementVariables element;
};

/// The values of a frame, in the order of the variables.
struct ResultsFrame {
  std::vector<std::vector<double>> nodal;  ///< one per node of the mesh
  std::vector<double> global;
  std::vector<std::vector<double>> element;  ///< one per element of the mesh; those of blocks without the variable are left out
};

/// Writes one Exodus file frame by frame; each frame is flushed, so that a stopped run leaves a readable file.
/// Used on rank 0 only, with gathered fields.
class ResultsFile {
 public:
  /// Begins a file. @throws FileError
  ResultsFile(const std::filesystem::path& file, const Mesh& mesh, const std::string& title, ResultsVariables variables);
  /// Goes on with a file behind its first `n_frames` frames; later ones are cut off. The variables as when it was begun.
  /// @throws FileError if it is no such file, or holds fewer frames
  ResultsFile(const std::filesystem::path& file, const Mesh& mesh, int n_frames, ResultsVariables variables);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Appends a frame. @throws FileError (e.g. disk full)
  void write(double time, const ResultsFrame& frame);

  int n_frames() const { return frame_; }

 private:
  /// Where the elements of a block are.
  struct BlockPlace {
    std::int64_t id, first, count;
  };
  static std::vector<BlockPlace> places(const Mesh& mesh);

  std::filesystem::path file_;
  int exodus_id_ = -1;
  int n_nodes_ = 0;
  int frame_ = 0;
  ResultsVariables variables_;
  std::vector<BlockPlace> blocks_;
};

}  // namespace mortise
