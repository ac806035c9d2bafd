#pragma once

#include <fmt/format.h>

#include <string>

namespace morphe::physics {

/// A block of 0.1 kg between two pads that slide towards it along x, gravity along -z, with the
/// contacts of `simulate`. Motors "left" and "right" are forces. With a push of 3 N a pad Coulomb
/// asks for a friction of 0.1 · 9.81 / (2 · 3) = 0.1635. `aside` is where along y the pads press
/// [m].
inline std::string pinched_block(double friction, double torsion_m, double aside = 0) {
  std::string pairs;
  for (const char* pad : {"left", "right"}) {
    pairs += fmt::format(
        "<pair geom1=\"block\" geom2=\"{}\" condim=\"6\" friction=\"{} {} {} 0.001 0.001\" "
        "solref=\"0.005 1\" solimp=\"0.5 0.99 0.0001\"/>",
        pad, friction, friction, torsion_m);
  }
  const auto pad = [&](const char* name, double x, double along) {
    return fmt::format(
        "<body pos=\"{} {} 0\"><joint name=\"{}\" type=\"slide\" axis=\"{} 0 0\"/>"
        "<inertial pos=\"0 0 0\" mass=\"0.05\" diaginertia=\"1e-5 1e-5 1e-5\"/>"
        "<geom name=\"{}\" type=\"sphere\" size=\"0.01\" contype=\"0\" conaffinity=\"0\"/></body>",
        x, aside, name, along, name);
  };
  return "<mujoco><option timestep=\"0.002\" integrator=\"implicit\" cone=\"elliptic\" "
         "impratio=\"10\" noslip_iterations=\"5\" gravity=\"0 0 -9.81\"/>"
         "<compiler inertiafromgeom=\"false\"/><worldbody>" +
         pad("left", -0.03, 1) + pad("right", 0.03, -1) +
         "<body name=\"block\"><freejoint/>"
         "<inertial pos=\"0 0 0\" mass=\"0.1\" diaginertia=\"7e-5 7e-5 7e-5\"/>"
         "<geom name=\"block\" type=\"box\" size=\"0.02 0.04 0.02\" contype=\"0\" "
         "conaffinity=\"0\"/></body></worldbody><contact>" +
         pairs +
         "</contact><actuator><motor name=\"left\" joint=\"left\"/>"
         "<motor name=\"right\" joint=\"right\"/></actuator></mujoco>";
}

}  // namespace morphe::physics
