#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include <cable_variation/GenerateEnvelope.h>
#include <cable_variation/GenerateEnvelopeAction.h>
#include <cable_variation/SimulateVariation.h>
#include <cable_variation/SimulateVariationAction.h>

#include <ros_interface/context/measured_shape.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/context/solver_diagnostics.h>
#include <ros_interface/context/state_file.h>
#include <ros_interface/display/clip_frames.h>
#include <ros_interface/display/design_publisher.h>
#include <ros_interface/display/envelope_publisher.h>
#include <ros_interface/display/interference_publisher.h>
#include <ros_interface/display/live_publisher.h>
#include <ros_interface/display/path_publisher.h>
#include <ros_interface/display/solver_publisher.h>
#include <ros_interface/display/tube_publisher.h>
#include <ros_interface/display/variation_publisher.h>
#include <ros_interface/interaction/drag_server.h>
#include <ros_interface/live/attachment_follower.h>
#include <ros_interface/live/event_publisher.h>
#include <ros_interface/live/shape_watch.h>
#include <ros_interface/live/tf_follower.h>
#include <ros_interface/node/node_parameters.h>
#include <ros_interface/node/own_thread_service.h>
#include <ros_interface/node/spinning_thread.h>
#include <ros_interface/request/name_registry.h>
#include <ros_interface/runs/envelope_run.h>
#include <ros_interface/runs/request_runner.h>
#include <ros_interface/runs/runner.h>
#include <ros_interface/runs/simulation_run.h>
#include <ros_interface/services/analyze_stability_service.h>
#include <ros_interface/services/check_forbidden_region_service.h>
#include <ros_interface/services/check_path_service.h>
#include <ros_interface/services/design_service.h>
#include <ros_interface/services/get_scene_service.h>
#include <ros_interface/services/load_scene_service.h>
#include <ros_interface/services/run_action_server.h>
#include <ros_interface/services/save_scene_service.h>
#include <ros_interface/services/set_attachment_service.h>
#include <ros_interface/services/solve_equilibrium_service.h>

namespace cable_variation_ros {

/// The node cable_solver: equilibria, stability, envelopes and production on request, and the design in force
/// to be seen.
class CableSolver {
 public:
  /// Throws what loadScene() throws. A scene whose harness has no equilibrium is
  /// accepted: diagnostics and the log say so.
  CableSolver(ros::NodeHandle node, const CableSolverParameters& parameters);
  ~CableSolver();

 private:
  void show();
  /// What some design variables do to the cables; none: all.
  void analyse(const std::vector<std::string>& variables);
  void showAgain();  ///< the figures, with a newer stamp

  ros::NodeHandle node_;
  SolverContext context_;
  StateFile state_;
  MeasuredShape measured_;
  SpinningThread spinning_;
  NameRegistry names_;
  InterferencePublisher interference_;
  SolverPublisher publisher_;
  LivePublisher live_publisher_;
  ClipFrames clip_frames_;
  ShapeWatch shape_watch_;
  EventPublisher events_;
  TubePublisher tubes_;
  VariationPublisher variation_;
  EnvelopePublisher envelope_;
  PathPublisher path_;
  DesignPublisher design_state_;
  SolverDiagnostics diagnostics_;
  SolveEquilibriumService solve_equilibrium_;
  AnalyzeStabilityService analyze_stability_;
  GetSceneService get_scene_;
  LoadSceneService load_scene_;
  SaveSceneService save_scene_;
  DesignService design_;
  SetAttachmentService set_attachment_;
  CheckForbiddenRegionService check_forbidden_region_;
  CheckPathService check_path_;
  Runner runner_;
  RequestRunner<EnvelopeRun> envelopes_;
  OwnThreadService<cable_variation::GenerateEnvelope> generate_envelope_;
  RunActionServer<cable_variation::GenerateEnvelopeAction, EnvelopeRun> generate_envelope_action_;
  RequestRunner<SimulationRun> simulations_;
  OwnThreadService<cable_variation::SimulateVariation> simulate_variation_;
  RunActionServer<cable_variation::SimulateVariationAction, SimulationRun> simulate_variation_action_;
  ros::WallTime shown_;  ///< last
  std::unique_ptr<DragServer> drags_;
  std::unique_ptr<TfFollower> follower_;
  std::unique_ptr<AttachmentFollower> attachments_;
};

}  // namespace cable_variation_ros
