#pragma once

#include <string>

#include <OgreMaterial.h>

namespace cable_variation_rviz {

/// Materials for surfaces with a colour at each vertex. The light comes from the camera: what faces it has
/// just its colour, as a legend has it, what is seen at a grazing angle is darker. Whatever lights RViz has.

/// Opaque.
Ogre::MaterialPtr litMaterial();

/// Translucent: of walls behind one another the nearest one alone is drawn, from whatever side.
Ogre::MaterialPtr translucentMaterial();

/// The same for a shell around something: clear where it is looked through, denser at its rim, and not in the
/// way of the mouse.
Ogre::MaterialPtr shellMaterial();

/// A technique for each way in which RViz looks for what is under the mouse, in which the material is not
/// there.
void hideFromMouse(Ogre::Material& material);

/// A name for an Ogre resource that no other has.
std::string uniqueName(const char* what);

}  // namespace cable_variation_rviz
