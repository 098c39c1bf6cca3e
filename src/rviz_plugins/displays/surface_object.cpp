#include <rviz_plugins/displays/surface_object.h>

#include <OgreManualObject.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>

#include <rviz_plugins/displays/surface_material.h>

namespace cable_variation_rviz {

namespace {

constexpr std::size_t kShortIndices = 65536;  // vertices that they can tell apart

}  // namespace

SurfaceObject::SurfaceObject(Ogre::SceneManager& scene, Ogre::SceneNode& parent)
    : scene_(scene),
      node_(parent.createChildSceneNode()),
      object_(scene.createManualObject(uniqueName("surface"))) {
  object_->setDynamic(true);
  node_->attachObject(object_);
}

SurfaceObject::~SurfaceObject() {
  scene_.destroyManualObject(object_);
  scene_.destroySceneNode(node_);
}

void SurfaceObject::set(const Surface& surface, const std::vector<Eigen::Vector4f>& colors,
                        const Ogre::MaterialPtr& material) {
  const std::size_t count = surface.triangles.empty() ? 0 : surface.positions.size();
  if (count == 0 || (vertices_ > kShortIndices) != (count > kShortIndices)) {
    object_->clear();
    vertices_ = 0;
  }
  if (count == 0) return;
  object_->estimateVertexCount(count);
  object_->estimateIndexCount(surface.triangles.size());
  if (vertices_ == 0) {
    object_->begin(material->getName(), Ogre::RenderOperation::OT_TRIANGLE_LIST, material->getGroup());
  } else {
    object_->beginUpdate(0);
  }
  vertices_ = count;
  Ogre::AxisAlignedBox box;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f &at = surface.positions[i], &normal = surface.normals[i];
    object_->position(at.x(), at.y(), at.z());
    object_->normal(normal.x(), normal.y(), normal.z());
    object_->colour(colors[i][0], colors[i][1], colors[i][2], colors[i][3]);
    box.merge(Ogre::Vector3(at.x(), at.y(), at.z()));
  }
  for (const std::uint32_t vertex : surface.triangles) object_->index(vertex);
  object_->end();
  object_->setBoundingBox(box);  // its own only grows
  object_->setMaterialName(0, material->getName(), material->getGroup());
  node_->needUpdate();
}

void SurfaceObject::drawLast() { object_->setRenderQueueGroup(Ogre::RENDER_QUEUE_8); }

}  // namespace cable_variation_rviz
