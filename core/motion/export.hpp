#pragma once

/// What libmorphe shows to those who link it; everything else is hidden.
#define MORPHE_EXPORT __attribute__((visibility("default")))
