#pragma once

#include <vector>

#include <shape_msgs/Mesh.h>

#include <cable_variation/GenerateEnvelope.h>

#include <cable_variation/envelope/clearance/envelope_clearance.h>

namespace cable_variation_ros {

shape_msgs::Mesh toMesh(const cable_variation::TriangleMesh& mesh);

/// Everything but the status, the mesh, files and what only the caller knows.
cable_variation::GenerateEnvelopeResponse toResponse(
    const cable_variation::Scene& scene, const cable_variation::Envelope& envelope,
    const std::vector<cable_variation::EnvelopeClearance>& clearances);

}  // namespace cable_variation_ros
