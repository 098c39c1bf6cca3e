#include <ros_interface/cable_solver.h>
#include <ros_interface/node/node_main.h>

namespace {

constexpr char kHelp[] =
    "Solves the cables of a scene on request and shows them. Parameters:\n"
    "  scene             scene file: path or package:// address; required\n"
    "  live              the cables follow their components on tf (false)\n"
    "  live_rate         how often they follow, at most (200) [Hz]\n"
    "  live_topics       a topic for each measure too (false)\n"
    "  tf_timeout        how old the tf of a component may get before it is told (1) [s]\n"
    "  interactive       clips and components can be dragged in RViz (true)\n"
    "  threads           for envelopes and simulations; 0: as many as there are cores (0)\n"
    "  memory_limit      what one envelope or simulation may take, about (2e9) [B]\n"
    "  memory_total      what all of them at work at once may (8e9) [B]\n"
    "  state_file        where what is in force is kept for the next start; empty: nowhere\n"
    "  output_directory  the only folder that files are written to (cable_variation in $ROS_HOME)\n"
    "  author            named in reports\n"
    "  limits/...        what files may hold\n";

}  // namespace

int main(int argc, char** argv) {
  using namespace cable_variation_ros;
  return runNode<CableSolver>(argc, argv, "cable_solver", kHelp, readCableSolverParameters);
}
