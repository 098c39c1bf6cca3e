#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cable_variation/math/pose.h>
#include <cable_variation/rod/cable.h>

namespace cable_variation {

/// A scene as it is to be written: names are those of the scene file, `comment` is written beside its thing.
struct SceneDraft {
  struct Component {
    std::string name;
    Pose pose;  ///< in the world
    std::string comment;
  };
  /// A uniform part of a cable, up to `end`.
  struct Part {
    double end = 0.0;  ///< [m], from the cable's start
    Section section;
    std::string comment;
  };
  struct Cable {
    std::string name;
    double length = 0.0;                          ///< [m]
    std::vector<Part> parts;                      ///< the last one ends where the cable does
    std::vector<Eigen::Vector3d> via;             ///< [m]
    std::vector<RestCurvatureAt> rest_curvature;  ///< none: it is straight
  };
  struct Clip {
    std::string name;
    std::string type;
    std::string more;  ///< further keys with values; or empty
    std::size_t cable = 0;
    double at = 0.0;  ///< [m]
    std::string component;
    Pose pose;  ///< in the component's frame
    std::string comment;
  };
  struct Joint {
    std::string name;
    std::size_t parent = 0;
    double at = 0.0;  ///< [m]
    std::size_t child = 0;
    bool child_end = false;  ///< its end sits there, not its start
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  };
  /// A stretch of a cable compared with the route planned for it.
  struct Route {
    std::string name;
    std::string segment;  ///< id in the file
    std::size_t cable = 0;
    double from = 0.0, to = 0.0;          ///< [m]
    std::vector<Eigen::Vector3d> points;  ///< along the cable [m, world]
    std::optional<double> limit;          ///< of the deviation [m]
  };
  struct Variable {
    std::string name;
    std::string rest;  ///< keys with values
  };

  std::vector<std::string> head;  ///< comments at the top, a line each
  double accuracy = 1e-4;         ///< [m]
  std::vector<Component> components;
  std::vector<Cable> cables;
  std::vector<Clip> clips;
  std::vector<Joint> joints;
  std::vector<Variable> variables;
  std::vector<Route> routes;
};

/// The scene file of a draft.
std::string sceneText(const SceneDraft& draft);

/// A text as a name of a scene file: other characters than letters, digits and _-. become _; at most 150
/// bytes.
std::string sceneName(const std::string& text);

}  // namespace cable_variation
