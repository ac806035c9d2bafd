#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// A rigid object that carries markers, as a manifest names it.
struct MarkerObject {
  std::string name;
  std::vector<std::string>
      markers;  ///< names used here; one that ends in * means all that begin so
  std::string shape = "box";
  std::vector<double> size;  ///< [m] as SceneObject::size; empty = the extent of a box's markers
};
template <class Fields>
void fields(Fields& f, MarkerObject& o) {
  f.required("name", o.name);
  f.required("markers", o.markers);
  f("shape", o.shape);
  f("size", o.size);
}
std::string why_invalid(const MarkerObject& object);

/// Adds the object: the rigid motion of its markers. Their shape is the mean over all frames, each
/// brought onto the frame that shows most of them by the motion that fits best; the object's axes
/// are the principal axes of that shape, named such that they lie nearest to the world's in that
/// frame, its centre is that of the shape's extent along them. Poses stand where three markers not
/// in a line were seen; between them it moves as recorded_pose says, which is reported, as is the
/// root mean square of what is not rigid. The markers stay in the stream. InputError "FILE:
/// objects: …" if a marker was not recorded, or no frame shows three of them, or the extent of the
/// markers is no box.
void add_marker_object(const std::string& file, const MarkerObject& object,
                       Demonstration& demonstration);

}  // namespace morphe::imports
