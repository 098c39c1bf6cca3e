#include <ros_interface/conversion/stability_conversion.h>

#include <ros_interface/conversion/matrix_conversion.h>
#include <ros_interface/conversion/measure_conversion.h>
#include <ros_interface/conversion/message_conversion.h>
#include <ros_interface/conversion/scene_conversion.h>

namespace cable_variation_ros {

using cable_variation::AnalyzeStabilityResponse;
using cable_variation::ComponentPoses;
using cable_variation::ComponentVariation;
using cable_variation::ComponentVariationInfo;
using cable_variation::DesignValues;
using cable_variation::LowHigh;
using cable_variation::PointVariation;
using cable_variation::Scene;
using cable_variation::StabilityAnalysis;

namespace {

ComponentVariationInfo toInfo(const ComponentVariation& variation, const Scene& scene,
                              const ComponentPoses& poses) {
  const std::string& name = scene.components[variation.component].name;
  const PointVariation most = largestVariation(scene, variation, poses.at(name));
  ComponentVariationInfo info;
  info.component = name;
  info.largest_six_sigma = most.six_sigma;
  info.at = toPoint(most.point);
  info.direction = toVector(most.direction);
  info.mean_shift = toVector(most.mean_shift);
  return info;
}

}  // namespace

AnalyzeStabilityResponse toResponse(const Scene& scene, const DesignValues& values,
                                    const StabilityAnalysis& analysis,
                                    const std::vector<ComponentVariation>& components,
                                    const ComponentPoses& poses) {
  AnalyzeStabilityResponse response;
  response.variables = toInfos(scene, analysis.variables, values);
  response.variable_sigma = listed(analysis.variable_sigma);
  for (std::size_t i = 0; i < analysis.measures.size(); ++i) {
    response.measures.push_back(toResult(scene.measures[analysis.measures[i]], analysis.values[i], scene));
  }
  response.jacobian = rowByRow(analysis.jacobian);
  response.contribution = rowByRow(analysis.contribution);
  for (const std::vector<LowHigh>& row : analysis.low_high) {
    for (const LowHigh& each : row) {
      response.low.push_back(each.low);
      response.high.push_back(each.high);
    }
  }
  response.one_sided.assign(analysis.one_sided.begin(), analysis.one_sided.end());
  response.mean_shift = listed(analysis.mean_shift);
  response.sigma = listed(analysis.sigma);
  response.worst_low = listed(analysis.worst_low);
  response.worst_high = listed(analysis.worst_high);
  response.smallest_eigenvalue = analysis.nominal.smallest_eigenvalue;
  response.eigenvalue_low = analysis.eigenvalue_low;
  response.eigenvalue_high = analysis.eigenvalue_high;
  for (const cable_variation::SnapWithin& snap : analysis.snaps) {
    cable_variation::VariableSnap info;
    info.variable = scene.design_variables[snap.variable].name;
    info.deviation = snap.deviation;
    info.jump = snap.jump;
    info.cable = scene.harness.cables[snap.cable].name;
    info.arc_length = snap.arc_length;
    response.snaps.push_back(info);
  }
  response.undefined = analysis.undefined;
  response.coupling = toString(analysis.coupling);
  response.warnings = analysis.warnings;
  for (const ComponentVariation& variation : components) {
    response.components.push_back(toInfo(variation, scene, poses));
  }
  response.linear_time = analysis.linear_time;
  response.resolve_time = analysis.resolve_time;
  return response;
}

}  // namespace cable_variation_ros
