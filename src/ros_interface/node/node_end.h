#pragma once

namespace cable_variation_ros {

/// From now on a node that is told to end notices it by goesOn(): by SIGINT and SIGTERM, and once ROS has
/// started (see endOnRequest()) by the master and `rosnode kill`. ROS itself goes on until the node has gone,
/// for what is made of it while it ends, as in the middle of a constructor, would break. What does not notice
/// ends in two seconds in any case, without a word: files are there complete or not at all even then.
void endOnSignals();
void endOnRequest();

/// Whether nobody has told the node to end; from any thread.
bool goesOn();

/// Has the thread that it is called on answer whatever comes to the node, until it is told to end. It ends
/// between two callbacks, however many wait.
void spinUntilTheEnd();

}  // namespace cable_variation_ros
