#include "core/store/hdf5_exit.hpp"

#include <hdf5.h>

namespace morphe::store {

void close_nothing_at_exit() { H5dont_atexit(); }

}  // namespace morphe::store
