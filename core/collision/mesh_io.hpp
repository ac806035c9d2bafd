#pragma once

#include <assimp/IOSystem.hpp>
#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "core/files/given_files.hpp"

namespace morphe::collision {

/// The files that assimp may read for a mesh: its own and those below its folder, which it names
/// (buffers of a glTF, materials), on the disk or among given files.
class MeshFiles : public Assimp::IOSystem {
 public:
  MeshFiles(const std::filesystem::path& mesh, const files::GivenFiles* given);

  bool Exists(const char* file) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

  /// Returns the files that were opened, in the order of their opening, each once.
  const std::vector<std::filesystem::path>& opened() const { return opened_; }

 private:
  std::filesystem::path folder_;
  const files::GivenFiles* given_;
  std::list<std::string> contents_;  ///< of the open streams
  std::vector<std::filesystem::path> opened_;
};

}  // namespace morphe::collision
