#pragma once

#include <string>
#include <vector>

#include <cable_variation/scene/scene.h>

namespace cable_variation {

/// A scene file's text with another scene's poses, arc lengths, lengths, sections and rest shapes, and with
/// the cables and clips that it has beyond `loaded`, in the place and the units of the old ones; all else,
/// comments and order too, is as it was.
/// @param text that `loaded` was read from
/// @param wanted made from it by edits, see sceneOf(const Design&)
/// Whether the text reads as `wanted`, requireSame() of what is read from it tells: an alias may stand for
/// values that are no longer the same. Throws std::invalid_argument for a text that is no map.
std::string editedSceneText(const std::string& text, const Scene& loaded, const Scene& wanted);

/// Throws std::invalid_argument that names what two scenes differ in, of what editedSceneText() writes: more
/// than 1e-8 m, 1e-8 rad or 1e-9 of a stiffness. The usual cause is a value that several things share by an
/// alias.
void requireSame(const Scene& saved, const Scene& wanted);

}  // namespace cable_variation
