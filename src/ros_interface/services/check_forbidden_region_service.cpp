#include <ros_interface/services/check_forbidden_region_service.h>

#include <numeric>
#include <set>

#include <ros/node_handle.h>

#include <cable_variation/envelope/forbidden_region.h>
#include <cable_variation/geometry/mesh/mesh_reader.h>
#include <cable_variation/measures/component_parts.h>
#include <cable_variation/measures/open_parts.h>
#include <cable_variation/util/error.h>
#include <cable_variation/util/regular_file.h>
#include <ros_interface/context/solver_context.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_loading.h>
#include <ros_interface/display/interference_publisher.h>
#include <ros_interface/markers/clearance_markers.h>
#include <ros_interface/node/names.h>
#include <cable_variation/analysis/name_lookup.h>
#include <ros_interface/request/request_status.h>

namespace cable_variation_ros {

using cable_variation::ComponentParts;
using cable_variation::ForbiddenRegion;
using cable_variation::InputLimits;
using cable_variation::Pose;
using cable_variation::readWhole;
using cable_variation::RegionClearance;
using cable_variation::RegionClearanceResult;
using cable_variation::RegularFile;
using cable_variation::Scene;
using cable_variation::TriangleMesh;

namespace {

// A saved region by its name in the output folder, where no link may lead out of it, or by an address.
std::string regionFile(const std::string& address, const cable_variation::OutputDirectory& output,
                       const InputLimits& limits, std::string& path) {
  const bool is_address = address.find("://") != std::string::npos;
  path = is_address ? resolveAddress(address, limits.region_bytes, limits.folders)
                    : output.pathOf(address, ".obj");
  try {
    return readWhole(path, limits.region_bytes,
                     is_address ? RegularFile::Links::follow : RegularFile::Links::refuse);
  } catch (const std::invalid_argument& error) {
    throw cable_variation::NotFound("region '" + address + "': '" + path + "' " + error.what());
  }
}

ForbiddenRegion loadRegion(const std::string& address, const cable_variation::OutputDirectory& output,
                           const InputLimits& limits) {
  std::string path;
  const std::string text = regionFile(address, output, limits, path);
  ForbiddenRegion region = cable_variation::parseRegion(text, path);
  if (region.frame != kWorldFrame) {
    throw std::invalid_argument("region '" + address + "': is in frame '" + region.frame + "', expected '" +
                                kWorldFrame + "'");
  }
  return region;
}

TriangleMesh loadMesh(const std::string& address, const geometry_msgs::Vector3& scale,
                      const InputLimits& limits) {
  if (address.find("://") == std::string::npos) {
    throw std::invalid_argument("mesh: '" + address + "', expected a package:// or file:// address");
  }
  const std::string path = resolveAddress(address, limits.mesh_bytes, limits.folders);
  Eigen::Vector3d factors = fromVector(scale);
  if (factors.isZero(0.0)) factors.setOnes();
  if (!factors.allFinite() || (factors.array() == 0.0).any()) {
    throw std::invalid_argument("scale: a factor is 0 or not finite, expected all three or none");
  }
  return cable_variation::readMesh(path, factors, limits);
}

Pose poseOf(geometry_msgs::Pose pose) {
  geometry_msgs::Quaternion& q = pose.orientation;
  if (q.w == 0.0 && q.x == 0.0 && q.y == 0.0 && q.z == 0.0) q.w = 1.0;
  return fromPose(pose, "pose");
}

/// One part's answer and what is to be seen of it.
/// @param mesh the part's; may be left out where nothing collides
void add(const ForbiddenRegion& region, const RegionClearance& found, const std::string& part,
         const cable_variation::PartOpenness& openness, const TriangleMesh& mesh, const Pose& pose,
         cable_variation::CheckForbiddenRegionResponse& response, InterferenceView& view) {
  const ForbiddenRegion::Piece& piece = region.pieces[found.piece];
  RegionClearanceResult result;
  result.part = part;
  result.distance = found.distance;
  result.on_region = toPoint(found.on_region);
  result.on_part = toPoint(found.on_part);
  result.cable = piece.cable;
  result.start = piece.start;
  result.end = piece.end;
  result.from_time = piece.from;
  result.to_time = piece.to;
  result.colliding_triangles = static_cast<std::uint32_t>(found.colliding.size());
  result.note = cable_variation::openPartWarning("'" + part + "'", openness);
  if (found.undecided)
    result.note += "; whether it holds some of the region there cannot be told: counted as not";
  response.clearances.push_back(result);

  const std::string marker_namespace = kRegionMarkers + part;
  if (found.distance <= kWorthShowing) {
    DistanceMark mark;
    mark.marker_namespace = marker_namespace;
    mark.point = found.on_region;
    mark.other = found.on_part;
    mark.text = "region " + distanceText(found.distance, 0.5 * (piece.start + piece.end));
    mark.interferes = found.distance < 0.0;
    view.marks.push_back(mark);
  }
  const auto triangles =
      triangleMarkers(marker_namespace + "/triangles", kWorldFrame, mesh, found.colliding, pose);
  view.triangles.insert(view.triangles.end(), triangles.begin(), triangles.end());
}

/// Makes ready the components to check, those asked for or all that have triangles, and tells which they are.
std::vector<std::size_t> prepare(const std::vector<std::string>& names, const Scene& scene,
                                 const ComponentParts& known, ComponentParts& parts) {
  if (!names.empty()) {
    const std::vector<std::size_t> asked = indicesOf(names, scene.components, "component");
    for (const std::size_t index : asked) parts.prepare(scene, index, known);
    return asked;
  }
  parts.prepareAll(scene, known);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < scene.components.size(); ++i) {
    if (parts.find(i) != nullptr) all.push_back(i);
  }
  return all;
}

}  // namespace

CheckForbiddenRegionService::CheckForbiddenRegionService(ros::NodeHandle& node, const SolverContext& context,
                                                         InterferencePublisher& interference,
                                                         const cable_variation::OutputDirectory& output)
    : context_(context),
      interference_(interference),
      output_(output),
      server_(
          node.advertiseService(kCheckForbiddenRegionService, &CheckForbiddenRegionService::handle, this)) {}

bool CheckForbiddenRegionService::handle(Request& request, Response& response) {
  response = answered<Response>([&] { return check(request); });
  return true;
}

void CheckForbiddenRegionService::contextChanged() {
  if (showing_) interference_.showRegion({});
  showing_ = false;
}

CheckForbiddenRegionService::Response CheckForbiddenRegionService::check(const Request& request) {
  if (!request.mesh.empty() && !request.components.empty()) {
    throw std::invalid_argument("mesh and components: both are given, expected one of them");
  }
  const ForbiddenRegion region = loadRegion(request.region, output_, context_.limits());
  Response response;
  InterferenceView view;
  if (!request.mesh.empty()) {
    const TriangleMesh mesh = loadMesh(request.mesh, request.scale, context_.limits());
    const Pose pose = poseOf(request.pose);
    const cable_variation::DistancePart part(mesh);
    add(region, checkRegion(region, part, pose), request.mesh, part.openness(), mesh, pose, response, view);
  } else {
    const Scene& scene = context_.design().scene;
    const SolverContext::Snapshot snapshot = context_.snapshot();
    const cable_variation::ComponentPoses poses =
        componentPosesAt(scene, context_.design().shifted, context_.moved());
    ComponentParts parts;
    for (const std::size_t index : prepare(request.components, scene, snapshot.parts, parts)) {
      const cable_variation::Component& component = scene.components[index];
      const Pose& pose = poses.at(component.name);
      const RegionClearance found = checkRegion(region, *parts.find(index), pose);
      const TriangleMesh mesh = found.colliding.empty() ? TriangleMesh() : mergedMesh(component);
      add(region, found, component.name, parts.find(index)->openness(), mesh, pose, response, view);
    }
  }
  std::set<std::string> cables;
  for (const ForbiddenRegion::Piece& piece : region.pieces) cables.insert(piece.cable);
  response.cables.assign(cables.begin(), cables.end());
  response.pieces = static_cast<std::uint32_t>(region.pieces.size());
  response.inflation = region.inflation;
  response.probability = region.probability;
  interference_.showRegion(std::move(view));
  showing_ = true;
  return response;
}

}  // namespace cable_variation_ros
