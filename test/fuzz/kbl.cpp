// A harness in KBL: refused with a message, or a draft of a scene comes of it that is one.
#include <cable_variation/import/kbl_import.h>
#include <cable_variation/scene_file/scene_reader.h>

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cable_variation;
  return acceptsOrRefuses([&] {
    std::string scene;
    try {
      scene = sceneText(importKbl(readKblText(textOf(data, size), "fuzz.kbl"), ImportMapping()).draft);
    } catch (const SceneError& error) {
      if (*error.what() == '\0') throw std::logic_error("a refusal without a message");
      return;
    }
    try {
      readSceneText(scene, "fuzz.yaml", [](const std::string&) { return std::string(); });
    } catch (const SceneError& error) {
      throw std::logic_error(std::string("a scene that is none: ") + error.what() + "\n" + scene);
    }
  });
}
