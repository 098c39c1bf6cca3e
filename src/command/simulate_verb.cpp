#include <atomic>
#include <filesystem>
#include <memory>
#include <utility>

#include <cable_variation/analysis/kept_blocks.h>
#include <cable_variation/analysis/simulation_calculation.h>
#include <cable_variation/util/error.h>
#include <command/loaded_design.h>
#include <command/ranks.h>
#include <command/scene_options.h>
#include <command/simulation_answer.h>
#include <command/verb.h>

namespace cable_variation_command {

using cable_variation::BlockFileHeader;
using cable_variation::KeptBlocks;
using cable_variation::SimulationCalculation;
using cable_variation::SimulationTask;
using cable_variation::StatusCode;

namespace {

class SimulateVerb : public Verb {
 public:
  void declare(Options& options) override {
    options_ = &options;
    scene_.declare(options);
    options.count("samples", "COUNT", request_.samples,
                  "10,000; with --sigma_error no more than these, 1,000,000");
    options.index("first_sample", "INDEX", request_.first_sample,
                  "a shard: --samples from this index on, kept in NAME.blocks for `cable_variation merge`");
    options.number("sigma_error", "SHARE", "1", request_.sigma_error,
                   "stop when each sigma is known to this share, as 2%; default: after --samples");
    options.number("confidence", "SHARE", "1", request_.confidence, "of all intervals; default: 95%");
    options.count("seed", "NUMBER", request_.seed, "same seed, same figures; default: 1");
    options.text("sampler", "NAME", request_.sampler, "monte_carlo, latin_hypercube or sobol");
    options.texts("variables", "NAME", request_.variables, "that vary within their tolerances; default: all");
    options.texts("measures", "NAME", request_.measures, "default: all of the scene");
    values_.declare("nominal_variables", "nominal_values", options);
    options.texts("motions", "NAME", request_.motions, "played together; default: at rest");
    options.number("from_time", "TIME", "s", request_.from_time, "of the motions");
    options.number("to_time", "TIME", "s", request_.to_time,
                   "likewise, default: their end; negative: at --from_time alone");
    options.count("sections", "COUNT", request_.sections, "along each cable, for the variation along it; 33");
    options.text("name", "NAME", request_.name,
                 "write NAME.csv, NAME_statistics.csv, NAME_contributions.csv and NAME.html");
    options.flag("resume", resume_,
                 "go on with a run of --name that was killed, from its last complete block");
    files_.declare(options);
    limits_.declare(options);
  }

  bool keepsWhatWasDone() const override { return simulating_; }

  Answer run(cable_variation::RunControl& control) override {
    const std::unique_ptr<Ranks> ranks = Ranks::join(limits_.threads, control);
    if (!ranks) return simulate(control, nullptr);
    try {
      Answer answer = simulate(control, ranks.get());
      ranks->leave();
      return answer;
    } catch (const std::exception& error) {
      if (ranks->isHelper()) return ranks->failed(error);  // the first rank says so
      ranks->leave();
      throw;
    }
  }

 private:
  void checkOptions() const {
    const bool is_shard = options_->given("first_sample");
    for (const char* const option : {"first_sample", "resume"}) {
      if (options_->given(option) && request_.name.empty())
        throw UsageError(std::string("--") + option + ": is given without --name, which its file has");
    }
    if (is_shard && request_.samples == 0)
      throw UsageError("--first_sample: is given without --samples, how many there are from there on");
  }

  Answer simulate(cable_variation::RunControl& control, Ranks* ranks) {
    checkOptions();
    LoadedDesign design(scene_.load(control), files_.author);
    values_.resolve(design.scene(), request_.nominal_variables, request_.nominal_values);
    if (request_.variables.empty()) request_.variables = {"*"};
    const SimulationTask task =
        toSimulationTask(request_, design.design(), {}, limits_.threads, limits_.memory_limit);
    const cable_variation::OutputDirectory output = files_.output();
    const bool writes = !task.name.empty() && (ranks == nullptr || !ranks->isHelper());
    if (writes) {
      output.requireWritable();
      requireSpace(output, task, design.scene());
    }
    const cable_variation::DesignSnapshot snapshot = snapshotFor(task.options, design.snapshot());
    const cable_variation::Scene& scene = snapshot.design.scene;
    const cable_variation::SolvedScene any = design.solved();
    const cable_variation::MeasureEvaluator evaluator = design.evaluator(any).with(scene, any);
    const cable_variation::SimulationIdentity identity = identityOf(task, snapshot);
    if (ranks != nullptr) ranks->agree(identity);
    control.throwIfCancelled();
    simulating_ = true;
    if (ranks != nullptr && ranks->isHelper()) {
      simulateVariation(scene, evaluator, task.options, solverAt(snapshot, task.options, task.other_design),
                        {}, control.observer(), ranks);
      return ranks->quiet();
    }
    std::unique_ptr<KeptBlocks> kept;
    if (writes) {
      const BlockFileHeader header{identity, requestLines(request_),
                                   std::filesystem::absolute(scene.source).string(),
                                   task.options.first_sample, task.options.samples};
      kept = std::make_unique<KeptBlocks>(output.fileFor(task.name, ".blocks"), header, resume_,
                                          options_->given("first_sample"));
    }
    if (ranks != nullptr) ranks->keepIn(kept.get());
    const SimulationCalculation found = calculateSimulation(
        task, snapshot, evaluator, output, control,
        ranks != nullptr ? static_cast<cable_variation::BlockExchange*>(ranks) : kept.get());
    Answer answer = simulationAnswer(scene, task.options.values, found);
    if (kept) tellOf(*kept, found, answer);
    return answer;
  }

  void tellOf(KeptBlocks& kept, const SimulationCalculation& found, Answer& answer) const {
    const bool complete = found.status.code == StatusCode::success;
    kept.finish(complete);
    const bool stays = !complete || options_->given("first_sample");
    answer.json.set("blocks_file", stays ? kept.path() : "").set("resumed_samples", kept.resumed());
    if (stays) answer.text += kept.path() + "\n";
    if (resume_) {
      answer.text += kept.resumed() == 0 ? "Nothing to go on with: all samples are new\n"
                                         : std::to_string(kept.resumed()) + " samples were there already\n";
    }
    std::string& message = answer.status.message;
    if (!kept.error().empty()) {
      message += (message.empty() ? "" : "; ") + kept.error();
      if (complete) answer.status.code = StatusCode::io_error;
    } else if (found.simulation.ended_early) {
      message += "; --resume goes on from there";
    }
  }

  const Options* options_ = nullptr;
  SceneOption scene_;
  ValueOptions values_;
  FileOptions files_;
  LimitOptions limits_;
  cable_variation::SimulationRequest request_;
  bool resume_ = false;
  std::atomic<bool> simulating_{false};
};

}  // namespace

std::unique_ptr<Verb> makeSimulate() { return std::make_unique<SimulateVerb>(); }

}  // namespace cable_variation_command
