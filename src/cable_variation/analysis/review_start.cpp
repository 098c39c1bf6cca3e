#include <cable_variation/analysis/review_start.h>

#include <cable_variation/analysis/scene_loading.h>
#include <cable_variation/util/utc_time.h>

namespace cable_variation {

Review startReview(const std::string& title, const DesignOrigin& origin, const Scene& scene,
                   const DesignValues& values, const SolvedScene& solved) {
  return {title,
          utcNow(),
          origin.author,
          {},
          warningsOf(scene),
          origin.source_hash,
          origin.changes,
          scene,
          values,
          solved,
          {},
          {},
          {},
          nullptr,
          nullptr,
          std::nullopt,
          std::nullopt};
}

std::string motionText(const Scene& scene, const std::vector<std::size_t>& motions) {
  std::string text;
  for (const std::size_t index : motions) text += (text.empty() ? "" : " and ") + scene.motions[index].name;
  return text;
}

}  // namespace cable_variation
