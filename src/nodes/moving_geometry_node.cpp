#include <ros_interface/moving_geometry.h>
#include <ros_interface/node/node_main.h>

namespace {

constexpr char kHelp[] =
    "Plays the recorded motions of a scene, shows what they move, and puts links where joint states have "
    "them. Parameters:\n"
    "  scene         scene file: path or package:// address; required unless follow\n"
    "  follow        start without a scene and show the solver's (false)\n"
    "  rate          of the transforms (50) [Hz]\n"
    "  joint_states  topic that robots' links follow (/joint_states)\n"
    "  loop          start again at the end of the longest motion (true)\n"
    "  speed         seconds of motion per second (1)\n"
    "  limits/...    what files may hold\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace cable_variation_ros;
  return runNode<MovingGeometry>(argc, argv, "moving_geometry_node", kHelp, readMovingGeometryParameters);
}
