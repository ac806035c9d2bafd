#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/key_bounds.hpp"

namespace morphe::imports {

/// A rigid object with markers, as listed in a manifest.
struct MarkerObject {
  std::string name;
  std::vector<std::string> markers;  ///< Morphe's names; one that ends in * is a prefix
  std::string shape = "box";         ///< sphere, box, cylinder or capsule
  std::vector<double> size;  ///< [m] as SceneObject::size; if empty, the extent of a box's markers
};
template <class Fields>
void fields(Fields& f, MarkerObject& o) {
  f.required("name", o.name);
  f.required("markers", o.markers);
  f("shape", o.shape);
  f("size", o.size, bounds::kObjectSize);
}
/// Returns a sentence about the first invalid field, or "" if all are valid.
std::string validation_error(const MarkerObject& object);

/// Adds the object, which moves rigidly with its markers; the markers stay in their stream. The
/// reference is the first frame that shows most of the markers. The shape of the markers is their
/// mean over all frames, each rigidly fitted to the reference. The object's axes are the principal
/// axes of the shape, in the order and signs nearest to the axes of the world in the reference; its
/// origin is the centre of the shape's box along them. Frames without three markers off a line have
/// no pose. Their number and the root mean square of the deviation from a rigid body are added to
/// `import_notes`. Throws InputError "FILE: objects: …" if a marker was not recorded, if no frame
/// has a pose, or if the size is not given and the box is thinner than 1 mm.
void add_marker_object(const std::string& file, const MarkerObject& object,
                       Demonstration& demonstration);

}  // namespace morphe::imports
