#include <command/verb.h>

namespace cable_variation_command {

const std::vector<VerbRow>& verbs() {
  static const std::vector<VerbRow> kVerbs{
      {"check", "all faults of a scene, what is implausible in it, and how large it is",
       "Reads the scene and all files that it names, and solves it as it is.", makeCheck},
      {"solve", "the shape that a harness takes, and all measures",
       "With some design variables off their nominal values, as ~solve_equilibrium does it.", makeSolve},
      {"stability", "which design variables drive which measures",
       "Derivatives, contributions, worst case, low and high, as ~analyze_stability has them.",
       makeStability},
      {"envelope", "the space that cables take up within their tolerances, and its clearances",
       "At rest or over motions, for the worst case or a share of production, as ~generate_envelope does it.",
       makeEnvelope},
      {"simulate", "production: statistics, capability and contributions of every measure",
       "Ctrl-C ends it with what was done by then. As ~simulate_variation does it.", makeSimulate},
      {"merge", "shards of a simulation, as one",
       "What `simulate --first_sample` has left in files NAME.blocks, on one machine or many: the figures "
       "and\n"
       "files of one run, bit for bit (doc/scaling.md).",
       makeMerge},
      {"report", "all of it on one page, with verdicts",
       "The design at rest, its stability analysis, a simulation and the envelope.", makeReport},
      {"import", "a harness from its KBL file, as a scene file",
       "Segments become cables and joints, placed parts clips; what the file lacks comes from a mapping\n"
       "(doc/import.md). All that is stale or missing in the file is told with its ids.",
       makeImport},
      {"export", "the shape that a harness takes, as files for other programs",
       "Positions, forces and moments along the cables as CSV and VTK, curves as DXF, surfaces as STL.",
       makeExport},
      {"identify", "design variables found from measured points of a cable",
       "Stiffness, rest curvature, directions of clamps: whatever of the scene's design variables is "
       "unknown,\n"
       "with standard deviations; what the points do not tell is said.",
       makeIdentify},
  };
  return kVerbs;
}

}  // namespace cable_variation_command
