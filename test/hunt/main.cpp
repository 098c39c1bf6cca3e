// hunt: random harnesses, each answer checked independently (doc/hunt.md).

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <cable_variation/scene_file/scene_reader.h>
#include <hunt/descent_sweep.h>
#include <hunt/run.h>
#include <hunt/scene_writer.h>

namespace {

using namespace cable_variation::hunt;

constexpr const char* kUsage =
    "usage: hunt [--count N] [--seed S] [--family F]... [--first I] [--starts-every K] [--starts N] "
    "[--accuracy M]\n"
    "            [--threads T] [--output FOLDER] [--slender] [--descent] [--all] [--check] [SCENE]...\n"
    "  --count N         harnesses of each family (25), or of each row with --slender (30)\n"
    "  --starts-every K  look for lower shapes by simple starts in every K-th solved harness (1); 0: in "
    "none\n"
    "  --starts N        how many simple starts (6)\n"
    "  --output FOLDER   writes each harness that failed there, as a scene file\n"
    "  --slender         the slenderness table instead of families\n"
    "  --descent         what half and twice of each number of DescentOptions cost, instead\n"
    "  --all             tells of what is right, too\n"
    "  --check           exit code 1 when more is wrong than what is aimed at (doc/hunt.md)\n"
    "  SCENE             judges the harness of that scene file instead; no package:// addresses\n";

struct Arguments {
  HuntOptions options;
  std::string output;
  std::vector<std::string> scenes;
  bool slender = false, descent = false, all = false, check = false, counted = false;
};

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key == "--help") {
      std::cout << kUsage;
      std::exit(EXIT_SUCCESS);
    }
    if (key == "--slender") {
      arguments.slender = true;
      continue;
    }
    if (key == "--descent") {
      arguments.descent = true;
      continue;
    }
    if (key == "--check") {
      arguments.check = true;
      continue;
    }
    if (key == "--all") {
      arguments.all = true;
      continue;
    }
    if (key.compare(0, 2, "--") != 0) {
      arguments.scenes.push_back(key);
      continue;
    }
    if (i + 1 == argc) throw std::invalid_argument("'" + key + "' is unknown or lacks its value");
    const std::string value = argv[++i];
    const auto number = [&] { return std::stoull(value); };
    if (key == "--count") {
      arguments.options.count = number();
      arguments.counted = true;
    } else if (key == "--seed") {
      arguments.options.seed = number();
    } else if (key == "--family") {
      arguments.options.only.push_back(familyOf(value).name);
    } else if (key == "--first") {
      arguments.options.first = number();
    } else if (key == "--starts-every") {
      arguments.options.starts_every = number();
    } else if (key == "--accuracy") {
      arguments.options.judge.accuracy = std::stod(value);
    } else if (key == "--starts") {
      arguments.options.judge.starts = static_cast<int>(number());
    } else if (key == "--threads") {
      arguments.options.threads = static_cast<unsigned>(number());
    } else if (key == "--output") {
      arguments.output = value;
    } else {
      throw std::invalid_argument("'" + key + "' is unknown");
    }
  }
  return arguments;
}

void tell(const Hunted& hunted, const Arguments& arguments) {
  const Judgement& judgement = hunted.judgement;
  const bool good = judgement.verdict == Verdict::right || judgement.verdict == Verdict::not_solvable;
  const std::string text = hunted.family + " " + std::to_string(hunted.number) + ": " +
                           toString(judgement.verdict) +
                           (judgement.text.empty() ? "" : ": " + judgement.text);
  if (!good || judgement.undecided || arguments.all) std::cerr << text << '\n';
  if ((good && !judgement.undecided) || arguments.output.empty()) return;
  std::string name = toString(judgement.verdict);
  name += "_" + hunted.family + "_" + std::to_string(arguments.options.seed) + "_" +
          std::to_string(hunted.number);
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_') c = '_';
  }
  std::ofstream file(std::filesystem::path(arguments.output) / (name + ".yaml"));
  file << sceneOf(hunted.harness, arguments.options.judge.accuracy, text);
  if (!file) throw std::runtime_error("cannot write " + name + ".yaml to " + arguments.output);
}

// A scene judged by itself.
std::vector<Tally> judgeScenes(const Arguments& arguments) {
  std::vector<Tally> tallies;
  for (const std::string& path : arguments.scenes) {
    const cable_variation::Scene scene =
        cable_variation::readScene(path, [](const std::string&) { return std::string(); });
    JudgeOptions options = arguments.options.judge;
    options.accuracy = scene.accuracy;
    options.seed = arguments.options.seed;
    Hunted hunted;
    hunted.family = std::filesystem::path(path).stem().string();
    hunted.harness = scene.harness;
    hunted.judgement = judge(hunted.harness, options);
    tell(hunted, arguments);
    tallies.emplace_back();
    tallies.back().name = hunted.family;
    tallies.back().add(hunted.judgement);
  }
  return tallies;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    Arguments arguments = parse(argc, argv);
    if (!arguments.output.empty()) std::filesystem::create_directories(arguments.output);
    const auto each = [&arguments](const Hunted& hunted) { tell(hunted, arguments); };
    if (arguments.descent) {
      std::size_t total = 0;
      const std::vector<DescentTry> tries = sweepDescent(arguments.options, total);
      std::cout << tableOf(tries, total);
      return EXIT_SUCCESS;
    }
    std::vector<Tally> tallies;
    if (!arguments.scenes.empty()) {
      tallies = judgeScenes(arguments);
    } else if (arguments.slender) {
      const std::size_t count = arguments.counted ? arguments.options.count : 30;
      tallies = huntSlender(count, {1e7, 1e8, 1e9, 1e10}, arguments.options, each);
    } else {
      tallies = hunt(arguments.options, each);
    }
    std::cout << tableOf(tallies);
    if (!arguments.check) return EXIT_SUCCESS;
    const std::vector<std::string> missed = missedTargets(sum(tallies));
    for (const std::string& target : missed) std::cout << target << '\n';
    return missed.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::cerr << "hunt: " << error.what() << '\n' << kUsage;
    return 2;
  }
}
