#include <atomic>
#include <memory>
#include <stdexcept>
#include <utility>

#include <cable_variation/analysis/kept_blocks.h>
#include <cable_variation/analysis/simulation_calculation.h>
#include <command/loaded_design.h>
#include <command/scene_options.h>
#include <command/simulation_answer.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::BlockFileHeader;
using cable_variation::BlockFileReader;
using cable_variation::KeptBlocks;
using cable_variation::SimulationTask;

namespace {

class MergeVerb : public Verb {
 public:
  void declare(Options& options) override {
    options.words("SHARDS", shards_, "files NAME.blocks of `simulate --first_sample`, in any order");
    options.text("scene", "SCENE", scene_.scene, "where the scene is now; default: where it was simulated");
    options.text("name", "NAME", name_,
                 "write NAME.csv, NAME_statistics.csv, NAME_contributions.csv and NAME.html");
    files_.declare(options);
    limits_.declare(options);
  }

  bool keepsWhatWasDone() const override { return merging_; }

  Answer run(cable_variation::RunControl& control) override {
    control.report({"reading"});
    std::vector<BlockFileReader> shards = cable_variation::checkedShards(shards_);
    const BlockFileHeader header = shards.front().header();
    cable_variation::SimulationRequest request = cable_variation::requestFrom(header.request);
    request.name = name_;
    for (const BlockFileReader& shard : shards)
      request.samples = std::max(request.samples, shard.header().end());
    if (scene_.scene.empty()) scene_.scene = header.scene;

    LoadedDesign design(scene_.load(control), files_.author);
    const SimulationTask task =
        toSimulationTask(request, design.design(), {}, limits_.threads, limits_.memory_limit);
    const cable_variation::OutputDirectory output = files_.output();
    if (!task.name.empty()) output.requireWritable();
    const cable_variation::DesignSnapshot snapshot = snapshotFor(task.options, design.snapshot());
    const std::string difference = cable_variation::differenceOf(
        header.identity, "in '" + shards_.front() + "'", identityOf(task, snapshot), "here");
    if (!difference.empty()) throw std::invalid_argument("shards are of another simulation: " + difference);
    const cable_variation::Scene& scene = snapshot.design.scene;
    const cable_variation::SolvedScene any = design.solved();
    const cable_variation::MeasureEvaluator evaluator = design.evaluator(any).with(scene, any);
    control.throwIfCancelled();
    merging_ = true;
    const std::size_t count = shards.size();
    KeptBlocks kept(std::move(shards));
    const cable_variation::SimulationCalculation found =
        calculateSimulation(task, snapshot, evaluator, output, control, &kept);
    Answer answer = simulationAnswer(scene, task.options.values, found);
    answer.json.set("shards", count).set("blocks_solved_again", kept.cut());
    answer.text += std::to_string(count) + (count == 1 ? " shard" : " shards");
    if (kept.cut() > 0)
      answer.text +=
          "; " + std::to_string(kept.cut()) + " blocks of 128 samples that shards' ends cut, solved again";
    answer.text += "\n";
    return answer;
  }

 private:
  std::vector<std::string> shards_;
  SceneOption scene_;
  FileOptions files_;
  LimitOptions limits_;
  std::string name_;
  std::atomic<bool> merging_{false};
};

}  // namespace

std::unique_ptr<Verb> makeMerge() { return std::make_unique<MergeVerb>(); }

}  // namespace cable_variation_command
