#pragma once

namespace cable_variation_ros {

/// The frame every scene hangs in.
constexpr char kWorldFrame[] = "world";
/// The same place, so that the world is on tf even where nothing else is.
constexpr char kSceneFrame[] = "scene";

// Topics and services, relative to a node's private namespace.
constexpr char kComponentsTopic[] = "components";
constexpr char kComponentDeviationsTopic[] = "component_deviations";
constexpr char kCablesTopic[] = "cables";
constexpr char kDesignTopic[] = "design";
constexpr char kShapesTopic[] = "shapes";
constexpr char kVariationTopic[] = "variation";
constexpr char kLegendTopic[] = "legend";
constexpr char kTubesTopic[] = "tubes";
constexpr char kLabelsTopic[] = "labels";
constexpr char kInterferenceTopic[] = "interference";
constexpr char kEnvelopeTopic[] = "envelope";
constexpr char kEnvelopeMeshTopic[] = "envelope_mesh";
constexpr char kMeasuresTopic[] = "measures";
constexpr char kReactionsTopic[] = "reactions";
constexpr char kReactionTopics[] = "reaction/";  // followed by a clip's name
constexpr char kLiveTopics[] = "live/";          // followed by a measure's name
constexpr char kMarksTopics[] = "marks/";        // followed by another topic of markers
constexpr char kEventsTopic[] = "events";
constexpr char kPathCheckTopic[] = "path_check";
constexpr char kMotionStateTopic[] = "motion_state";
constexpr char kPlayService[] = "play";
constexpr char kSeekService[] = "seek";
constexpr char kSolveEquilibriumService[] = "solve_equilibrium";
constexpr char kAnalyzeStabilityService[] = "analyze_stability";
constexpr char kGenerateEnvelopeService[] = "generate_envelope";
constexpr char kGenerateEnvelopeAction[] = "generate_envelope_action";
constexpr char kSimulateVariationService[] = "simulate_variation";
constexpr char kSimulateVariationAction[] = "simulate_variation_action";
constexpr char kCheckForbiddenRegionService[] = "check_forbidden_region";
constexpr char kCheckPathService[] = "check_path";
constexpr char kGetSceneService[] = "get_scene";
constexpr char kLoadSceneService[] = "load_scene";
constexpr char kSaveSceneService[] = "save_scene";
constexpr char kInteractionTopic[] = "interaction";
constexpr char kSetDesignService[] = "set_design";
constexpr char kSetAttachmentService[] = "set_attachment";
constexpr char kResetDesignService[] = "reset_design";

// Marker namespaces: these, followed by a name.
constexpr char kComponentMarkers[] = "component/";
constexpr char kCableMarkers[] = "cable/";
constexpr char kClipMarkers[] = "clip/";
constexpr char kContactMarkers[] = "contact/";
constexpr char kRouteMarkers[] = "route/";
constexpr char kVariationMarkers[] = "variation/";
constexpr char kVariationShapeMarkers[] = "variation_shapes/";
constexpr char kSensitivityMarkers[] = "sensitivity/";
constexpr char kInterferenceMarkers[] = "interference/";
constexpr char kClearanceMarkers[] = "interference/clearance/";
constexpr char kTriangleMarkers[] = "interference/triangles/";
constexpr char kRegionMarkers[] = "interference/region/";
constexpr char kEnvelopeMarkers[] = "envelope/";

}  // namespace cable_variation_ros
