// Writes doc/validation.md to the standard output: what the program calculates, compared with what is known.
// validation [FOLDER]: of measured data, with hanging_wires/ in it

#include <exception>
#include <iostream>

#include <cable_variation/util/version.h>

#include "validation.h"

namespace cable_variation::validation {
namespace {

void write(const Chapter& chapter) {
  std::cout << "\n## " << chapter.title << "\n" << chapter.about << "\n";
  if (!chapter.left_out.empty()) std::cout << "\n" << chapter.left_out << "\n";
  if (chapter.checks.empty()) return;
  std::cout << "\n| what | known | calculated | error | known from |\n|---|---|---|---|---|\n";
  for (const Check& check : chapter.checks)
    std::cout << "| " << check.what << " | " << check.expected << " | " << check.found << " | " << check.error
              << " | " << check.source << " |\n";
}

}  // namespace
}  // namespace cable_variation::validation

int main(int argc, char** argv) {
  using namespace cable_variation::validation;
  try {
    std::cout
        << "# Validation\n\nMade by `scripts/validate` of cable_variation "
        << cable_variation::packageVersion()
        << "; every figure of this page is calculated when it runs. To repeat it: `scripts/validate`, with "
           "`--data FOLDER` for what was measured and may not be shipped.\n";
    for (const Chapter& chapter : {closedForms(), referenceSolutions(), publishedBenchmarks(),
                                   hangingWires(argc > 1 ? std::string(argv[1]) + "/hanging_wires" : "")})
      write(chapter);
  } catch (const std::exception& error) {
    std::cerr << "validation: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
