#pragma once

namespace morphe {

struct SynthesizeOptions {};

}  // namespace morphe
