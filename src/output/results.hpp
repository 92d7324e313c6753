// The Exodus results of a run: geometry once, then one frame per output time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

/// Writes one Exodus file frame by frame; each frame is flushed, so that a stopped run leaves a readable file.
/// Used on rank 0 only, with gathered fields.
class ResultsFile {
 public:
  /// Begins a file.
  /// @param nodal names of nodal variables, e.g. "displacement_x" (ParaView joins _x _y _z to a vector)
  /// @param global names of global variables
  /// @throws FileError
  ResultsFile(const std::filesystem::path& file, const Mesh& mesh, const std::string& title, std::vector<std::string> nodal,
              std::vector<std::string> global);
  /// Goes on with a file behind its first `n_frames` frames; later ones are cut off. The names as when it was begun.
  /// @throws FileError if it is no such file, or holds fewer frames
  ResultsFile(const std::filesystem::path& file, const Mesh& mesh, int n_frames, std::vector<std::string> nodal,
              std::vector<std::string> global);
  ~ResultsFile();
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;

  /// Appends a frame. @param nodal one value per node of the mesh for each name given at construction; @param global likewise one
  /// value
  /// @throws FileError (e.g. disk full)
  void write(double time, const std::vector<std::vector<double>>& nodal, const std::vector<double>& global);

  int n_frames() const { return frame_; }

 private:
  std::filesystem::path file_;
  int exodus_id_ = -1;
  int n_nodes_ = 0;
  int frame_ = 0;
  std::vector<std::string> nodal_, global_;
};

}  // namespace mortise
