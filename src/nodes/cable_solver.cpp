#include <ros_interface/cable_solver.h>
#include <ros_interface/node/node_main.h>

int main(int argc, char** argv) {
  using namespace cable_variation_ros;
  return runNode<CableSolver>(argc, argv, "cable_solver", readCableSolverParameters);
}
