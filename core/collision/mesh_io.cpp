#include "core/collision/mesh_io.hpp"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "core/motion/input_error.hpp"

namespace morphe::collision {

namespace fs = std::filesystem;

MeshFiles::MeshFiles(const fs::path& mesh, const files::GivenFiles* given)
    : folder_(mesh.parent_path().lexically_normal()), given_(given) {}

bool MeshFiles::Exists(const char* file) const {
  const fs::path inside = fs::path(file).lexically_normal().lexically_proximate(folder_);
  if (inside.is_absolute() || inside.string().starts_with("..")) return false;
  if (given_) return !given_->find(file).empty();
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

Assimp::IOStream* MeshFiles::Open(const char* file, const char* mode) {
  if (*mode != 'r' || !Exists(file)) return nullptr;
  const fs::path found = files::located(file, given_);
  const std::string& bytes = contents_.emplace_back(files::read_bytes(found, given_));
  if (std::ranges::find(opened_, found) == opened_.end()) opened_.push_back(found);
  return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                    bytes.size());
}

void MeshFiles::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace morphe::collision
