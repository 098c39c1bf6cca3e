#pragma once

namespace cable_variation_ros {

/// The frame every scene hangs in.
constexpr char kWorldFrame[] = "world";

// Topics and services, relative to a node's private namespace.
constexpr char kComponentsTopic[] = "components";
constexpr char kComponentDeviationsTopic[] = "component_deviations";
constexpr char kCablesTopic[] = "cables";
constexpr char kShapesTopic[] = "shapes";
constexpr char kVariationTopic[] = "variation";
constexpr char kLegendTopic[] = "legend";
constexpr char kInterferenceTopic[] = "interference";
constexpr char kPlayService[] = "play";
constexpr char kSeekService[] = "seek";
constexpr char kSolveEquilibriumService[] = "solve_equilibrium";
constexpr char kAnalyzeStabilityService[] = "analyze_stability";
constexpr char kGetSceneService[] = "get_scene";
constexpr char kLoadSceneService[] = "load_scene";
constexpr char kSetDesignService[] = "set_design";
constexpr char kResetDesignService[] = "reset_design";

// Marker namespaces: these, followed by a name.
constexpr char kComponentMarkers[] = "component/";
constexpr char kCableMarkers[] = "cable/";
constexpr char kClipMarkers[] = "clip/";
constexpr char kVariationMarkers[] = "variation/";
constexpr char kSensitivityMarkers[] = "sensitivity/";
constexpr char kInterferenceMarkers[] = "interference/";

}  // namespace cable_variation_ros
