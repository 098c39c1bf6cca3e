#include <ros_interface/moving_geometry.h>
#include <ros_interface/node/node_main.h>

int main(int argc, char** argv) {
  using namespace cable_variation_ros;
  return runNode<MovingGeometry>(argc, argv, "moving_geometry_node", readMovingGeometryParameters);
}
