#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// A rigid object with markers, as listed in a manifest.
struct MarkerObject {
  std::string name;  ///< name of the object
  /// Names used here; one that ends in * stands for all with that prefix.
  std::vector<std::string> markers;
  std::string shape = "box";  ///< sphere, box, cylinder or capsule
  std::vector<double> size;   ///< [m] as SceneObject::size; if empty, the extent of a box's markers
};
template <class Fields>
void fields(Fields& f, MarkerObject& o) {
  f.required("name", o.name);
  f.required("markers", o.markers);
  f("shape", o.shape);
  f("size", o.size);
}
/// Returns a sentence about the first invalid field, or "" if all are valid.
std::string validation_error(const MarkerObject& object);

/// Adds the object with the rigid motion of its markers. Their shape is the mean over all frames,
/// each transformed to the frame that shows most of them by the best rigid fit. The object's axes
/// are the principal axes of that shape, permuted and signed to be nearest to the world's in that
/// frame; its centre is that of the shape's extent along them. Poses exist for frames in which
/// three non-collinear markers were seen; they are interpolated as in recorded_pose, which is
/// reported, as is the root mean square of the deviation from rigidity. The markers stay in the
/// stream. Throws InputError "FILE: objects: …" if a marker was not recorded, no frame shows three
/// of them, or the extent of the markers is not a box.
void add_marker_object(const std::string& file, const MarkerObject& object,
                       Demonstration& demonstration);

}  // namespace morphe::imports
