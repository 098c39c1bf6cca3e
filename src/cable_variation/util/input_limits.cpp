#include <cable_variation/util/input_limits.h>

namespace cable_variation {

const std::vector<InputLimitRow>& inputLimitRows() {
  using L = InputLimits;
  static const std::vector<InputLimitRow> rows{{"scene_bytes", &L::scene_bytes},
                                               {"urdf_bytes", &L::urdf_bytes},
                                               {"mesh_bytes", &L::mesh_bytes},
                                               {"collada_bytes", &L::collada_bytes},
                                               {"motion_bytes", &L::motion_bytes},
                                               {"samples_bytes", &L::samples_bytes},
                                               {"region_bytes", &L::region_bytes},
                                               {"triangles", &L::triangles},
                                               {"xml_parts", &L::xml_parts},
                                               {"poses", &L::poses},
                                               {"samples", &L::samples},
                                               {"components", &L::components},
                                               {"materials", &L::materials},
                                               {"cables", &L::cables},
                                               {"clips", &L::clips},
                                               {"joints", &L::joints},
                                               {"loads", &L::loads},
                                               {"contact", &L::contact},
                                               {"design_variables", &L::design_variables},
                                               {"correlations", &L::correlations},
                                               {"measures", &L::measures},
                                               {"motions", &L::motions},
                                               {"attachments", &L::attachments},
                                               {"sections", &L::sections},
                                               {"rest_points", &L::rest_points},
                                               {"via_points", &L::via_points},
                                               {"turns", &L::turns},
                                               {"name_bytes", &L::name_bytes},
                                               {"faults", &L::faults},
                                               {"import_seconds", &L::import_seconds},
                                               {"import_memory", &L::import_memory}};
  return rows;
}

std::string atMost(std::size_t bound, const char* name) {
  return "expected at most " + std::to_string(bound) + " (the limit " + name + ")";
}

}  // namespace cable_variation
