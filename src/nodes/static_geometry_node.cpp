#include <ros_interface/node/node_main.h>
#include <ros_interface/static_geometry.h>

namespace {

constexpr char kHelp[] =
    "Shows the components of a scene that nothing moves. Parameters:\n"
    "  scene       scene file: path or package:// address; required unless follow\n"
    "  follow      start without a scene and show the solver's (false)\n"
    "  limits/...  what files may hold\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace cable_variation_ros;
  return runNode<StaticGeometry>(argc, argv, "static_geometry_node", kHelp, readStaticGeometryParameters);
}
