#pragma once

#include <string>

#include "pipeline/setup/setup.hpp"

namespace morphe::setup {

/// Takes the ends of the arm from the chains of a description, if a person edited them: the first
/// joint (or link) of the chain "arm", and its last one where `--arm` is not given.
void follow_edited_chains(const std::string& before, SetupRequest& request);

}  // namespace morphe::setup
