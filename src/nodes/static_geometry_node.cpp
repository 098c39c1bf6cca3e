#include <ros_interface/node/node_main.h>
#include <ros_interface/static_geometry.h>

int main(int argc, char** argv) {
  using namespace cable_variation_ros;
  return runNode<StaticGeometry>(argc, argv, "static_geometry_node", readStaticGeometryParameters);
}
