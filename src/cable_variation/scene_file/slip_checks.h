#pragma once  // internal to scene_file/

#include <string>
#include <utility>
#include <vector>

#include <cable_variation/scene/scene.h>
#include <cable_variation/scene_file/yaml_cursor.h>

namespace cable_variation {

/// Units that a figure may have been meant in, with their SI factors.
using MeantUnits = std::vector<std::pair<const char*, double>>;

/// Items of a list of the scene file by what they are: "cable 'main'". None if the key is not there.
std::vector<YamlCursor> namedItems(const YamlCursor& root, const std::string& key, const std::string& kind);

/// "; in MPa or GPa?" for the units that a bare number would be plausible in, else "; is that meant?".
std::string meant(const YamlCursor& number, double value, const Range& plausible, const MeantUnits& units);

/// [m]; 0 without cables.
double longestCable(const Scene& scene);

/// Size of a component's bounding box in its own frame [m]; zero without visuals.
Eigen::Vector3d sizeOf(const Component& component);

/// "1350 x 900 x 0.5 m"
std::string sizeText(const Eigen::Vector3d& size);

void checkWorld(const YamlCursor& root, const Scene& scene);  ///< gravity and accuracy
void checkMaterials(const YamlCursor& root);                  ///< and those within sections
void checkComponents(const YamlCursor& root, const Scene& scene);
void checkCables(const YamlCursor& root, const Scene& scene);
void checkRouting(const YamlCursor& root, const Scene& scene);  ///< cables' lengths to their clips
void checkForces(const YamlCursor& root, const Scene& scene);
void checkTolerances(const YamlCursor& root, const Scene& scene);
void checkLimits(const YamlCursor& root, const Scene& scene);  ///< of measures

}  // namespace cable_variation
