#pragma once

namespace cable_variation_ros {

/// The frame every scene hangs in.
constexpr char kWorldFrame[] = "world";

// Topics and services, relative to a node's private namespace.
constexpr char kComponentsTopic[] = "components";
constexpr char kCablesTopic[] = "cables";
constexpr char kShapesTopic[] = "shapes";
constexpr char kPlayService[] = "play";
constexpr char kSeekService[] = "seek";
constexpr char kSolveEquilibriumService[] = "solve_equilibrium";
constexpr char kGetSceneService[] = "get_scene";
constexpr char kLoadSceneService[] = "load_scene";
constexpr char kSetDesignService[] = "set_design";
constexpr char kResetDesignService[] = "reset_design";

// Marker namespaces: these, followed by a name.
constexpr char kComponentMarkers[] = "component/";
constexpr char kCableMarkers[] = "cable/";
constexpr char kClipMarkers[] = "clip/";

}  // namespace cable_variation_ros
