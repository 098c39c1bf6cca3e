#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <cable_variation/scene/scene_contact.h>
#include <cable_variation/scene_file/read_context.h>

namespace cable_variation {
namespace {

constexpr Range kStandOff{0.0, 1.0, false};  // [m]

// The things that a list names, each once.
std::vector<std::size_t> readNames(const YamlCursor& list, const NameTable& names) {
  std::vector<std::size_t> found;
  for (const YamlCursor& item : list.items()) {
    const std::size_t index = names.find(item);
    if (index == NameTable::npos) continue;
    if (std::find(found.begin(), found.end(), index) != found.end()) {
      item.fail("'" + names.name(index) + "' is in the list already");
    }
    found.push_back(index);
  }
  if (list.isList() && list.items().empty()) list.fail("it is empty; expected a name at least");
  return found;
}

void readOne(const YamlCursor& item, SceneContact& contact, const ReadContext& context) {
  if (!item.checkKeys({"cables", "with", "stand_off", "skip_near_clips"})) return;
  if (const auto cables = item.require("cables")) contact.cables = readNames(*cables, context.cables);
  if (const auto parts = item.find("with")) {
    contact.components = readNames(*parts, context.components);
  } else {
    item.fail("contact of cables with each other is not yet known; expected 'with', a list of components");
  }
  contact.stand_off = item.number("stand_off", quantity::length, kStandOff, 0.0);
  contact.skip_near_clips = item.number("skip_near_clips", quantity::length, Range::notNegative(), 0.0);
}

// A cable and a part have one contact.
void checkPairs(const YamlCursor& item, const ReadContext& context) {
  const std::vector<SceneContact>& contacts = context.scene.contacts;
  const SceneContact& last = contacts.back();
  for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
    for (const std::size_t cable : last.cables) {
      for (const std::size_t component : last.components) {
        const auto has = [](const std::vector<std::size_t>& all, std::size_t one) {
          return std::find(all.begin(), all.end(), one) != all.end();
        };
        if (!has(contacts[i].cables, cable) || !has(contacts[i].components, component)) continue;
        item.fail("cable '" + context.cables.name(cable) + "' has contact with component '" +
                  context.components.name(component) + "' above already");
      }
    }
  }
}

}  // namespace

void readContacts(const YamlCursor& list, ReadContext& context) {
  const std::size_t before = context.faults.count();
  for (const YamlCursor& entry : list.items()) {
    const std::size_t number = context.scene.contacts.size() + 1;
    const YamlCursor item = entry.labelled("contact " + std::to_string(number));
    SceneContact contact;
    readOne(item, contact, context);
    context.scene.contacts.push_back(contact);
    checkPairs(item, context);
  }
  if (context.faults.count() > before) return;
  try {
    makeContacts(context.scene);
  } catch (const std::invalid_argument& error) {
    list.fail(error.what());
  }
}

}  // namespace cable_variation
