#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cable_variation {

/// How much is read of files that come from elsewhere, and from where. What goes beyond is refused before
/// the work it would take, with its size, the bound and the bound's name. The defaults are far above what
/// scenes of cars and machines have, and low enough for a node that answers others meanwhile.
struct InputLimits {
  std::vector<std::string> folders;  ///< that files must lie in, links followed; empty: anywhere

  // sizes of files [B]
  std::size_t scene_bytes = 16'000'000;
  std::size_t urdf_bytes = 64'000'000;
  std::size_t mesh_bytes = 2'000'000'000;
  std::size_t collada_bytes = 500'000'000;
  std::size_t motion_bytes = 1'000'000'000;
  std::size_t samples_bytes = 1'000'000'000;
  std::size_t region_bytes = 2'000'000'000;

  // of a file
  std::size_t triangles = 20'000'000;  ///< of a mesh, its polygons divided
  std::size_t xml_parts = 2'000'000;   ///< elements and attributes of a URDF or COLLADA file
  std::size_t poses = 5'000'000;       ///< of a recorded motion
  std::size_t samples = 5'000'000;     ///< of an empirical distribution

  // of a scene
  std::size_t components = 5'000;
  std::size_t materials = 5'000;
  std::size_t cables = 5'000;
  std::size_t clips = 5'000;
  std::size_t joints = 5'000;
  std::size_t loads = 10'000;
  std::size_t contact = 1'000;
  std::size_t design_variables = 5'000;
  std::size_t correlations = 10'000;
  std::size_t measures = 5'000;
  std::size_t motions = 1'000;
  std::size_t attachments = 10'000;
  std::size_t sections = 200;       ///< of one cable
  std::size_t rest_points = 1'000;  ///< of one rest shape, points or curvatures
  std::size_t via_points = 1'000;   ///< of one cable
  std::size_t turns = 200;          ///< of one cable's twist
  std::size_t name_bytes = 200;     ///< of a name in UTF-8
  std::size_t faults = 1'000;       ///< told of one scene; the reader stops there

  // of the process that imports COLLADA or a bag
  std::size_t import_seconds = 20;            ///< of time and of CPU time
  std::size_t import_memory = 2'000'000'000;  ///< [B]
};

/// One of the bounds: its name, as in the struct and in a node's parameters, and what it is of.
struct InputLimitRow {
  const char* name;
  std::size_t InputLimits::*value;
};

/// All of them but the folders.
const std::vector<InputLimitRow>& inputLimitRows();

/// For a message on what is beyond one: "expected at most 5000 (the limit clips)".
std::string atMost(std::size_t bound, const char* name);

}  // namespace cable_variation
