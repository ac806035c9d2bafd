#pragma once

/// Marks a symbol that libmorphe exports; all other symbols are hidden.
#define MORPHE_EXPORT __attribute__((visibility("default")))
