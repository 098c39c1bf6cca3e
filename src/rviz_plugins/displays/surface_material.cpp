#include <rviz_plugins/displays/surface_material.h>

#include <atomic>
#include <string>

#include <OgreHighLevelGpuProgram.h>
#include <OgreHighLevelGpuProgramManager.h>
#include <OgreMaterialManager.h>
#include <OgrePass.h>
#include <OgreTechnique.h>

namespace cable_variation_rviz {

namespace {

const char* const kVertexProgram = R"(#version 120
uniform mat4 worldviewproj;
uniform mat4 worldview;
varying vec3 place;
varying vec3 normal;
varying vec4 paint;
void main() {
  gl_Position = worldviewproj * gl_Vertex;
  place = (worldview * gl_Vertex).xyz;
  normal = (worldview * vec4(gl_Normal, 0.0)).xyz;
  paint = gl_Color;
}
)";

const char* const kFragmentProgram = R"(#version 120
uniform mat4 projection;
uniform float rim;
varying vec3 place;
varying vec3 normal;
varying vec4 paint;
void main() {
  vec3 to_camera = projection[3][3] > 0.5 ? vec3(0.0, 0.0, 1.0) : normalize(-place);
  float facing = abs(dot(normalize(normal), to_camera));
  float alpha = mix(paint.a, min(1.0, paint.a * mix(2.0, 0.6, facing)), rim);
  gl_FragColor = vec4(paint.rgb * (0.4 + 0.6 * facing), alpha);
}
)";

const Ogre::String& group() { return Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME; }

/// The program of this name, made if it is not there.
std::string program(const char* name, Ogre::GpuProgramType type, const char* source) {
  auto& manager = Ogre::HighLevelGpuProgramManager::getSingleton();
  if (!manager.resourceExists(name, group())) {
    manager.createProgram(name, group(), "glsl", type)->setSource(source);
  }
  return name;
}

/// A pass that lights vertices in their own colours.
void light(Ogre::Pass& pass, bool rim) {
  pass.setVertexProgram(program("cable_variation/surface_vertex", Ogre::GPT_VERTEX_PROGRAM, kVertexProgram));
  pass.setFragmentProgram(
      program("cable_variation/surface_fragment", Ogre::GPT_FRAGMENT_PROGRAM, kFragmentProgram));
  using Parameters = Ogre::GpuProgramParameters;
  const Ogre::GpuProgramParametersSharedPtr of_vertices = pass.getVertexProgramParameters();
  of_vertices->setNamedAutoConstant("worldviewproj", Parameters::ACT_WORLDVIEWPROJ_MATRIX);
  of_vertices->setNamedAutoConstant("worldview", Parameters::ACT_WORLDVIEW_MATRIX);
  const Ogre::GpuProgramParametersSharedPtr of_fragments = pass.getFragmentProgramParameters();
  of_fragments->setNamedAutoConstant("projection", Parameters::ACT_PROJECTION_MATRIX);
  of_fragments->setNamedConstant("rim", rim ? 1.0F : 0.0F);
}

Ogre::MaterialPtr newMaterial(const char* what) {
  return Ogre::MaterialManager::getSingleton().create(uniqueName(what), group());
}

Ogre::MaterialPtr nearestWall(const char* what, bool rim) {
  Ogre::MaterialPtr material = newMaterial(what);
  Ogre::Technique* technique = material->getTechnique(0);
  // First depth alone: what is nearest.
  Ogre::Pass* depth = technique->getPass(0);
  depth->setColourWriteEnabled(false);
  depth->setCullingMode(Ogre::CULL_NONE);
  depth->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  depth->setTransparentSortingForced(true);
  light(*depth, rim);  // by the same programs as its colour, for the same depths to the last bit
  Ogre::Pass* colour = technique->createPass();
  light(*colour, rim);
  colour->setCullingMode(Ogre::CULL_NONE);
  colour->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  colour->setDepthWriteEnabled(false);
  colour->setDepthFunction(Ogre::CMPF_LESS_EQUAL);
  return material;
}

}  // namespace

std::string uniqueName(const char* what) {
  static std::atomic<unsigned> count{0};
  return std::string("cable_variation/") + what + "/" + std::to_string(count++);
}

Ogre::MaterialPtr litMaterial() {
  Ogre::MaterialPtr material = newMaterial("lit");
  light(*material->getTechnique(0)->getPass(0), false);
  return material;
}

Ogre::MaterialPtr translucentMaterial() { return nearestWall("translucent", false); }

Ogre::MaterialPtr shellMaterial() {
  Ogre::MaterialPtr material = nearestWall("shell", true);
  hideFromMouse(*material);
  return material;
}

void hideFromMouse(Ogre::Material& material) {
  for (const char* scheme : {"Pick", "Pick1"}) {
    Ogre::Technique* technique = material.createTechnique();
    technique->setSchemeName(scheme);
    Ogre::Pass* pass = technique->createPass();
    pass->setColourWriteEnabled(false);
    pass->setDepthWriteEnabled(false);
  }
}

}  // namespace cable_variation_rviz
