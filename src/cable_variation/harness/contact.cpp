#include <cable_variation/harness/contact.h>

#include <stdexcept>

#include <cable_variation/harness/harness.h>

namespace cable_variation {

void requireNoContact(const Harness& harness, const std::string& what) {
  if (harness.contacts.empty()) return;
  const PartContact& contact = harness.contacts.front();
  throw std::invalid_argument("contact is not yet known to " + what + ", and cable '" +
                              harness.cables.at(contact.cable).name + "' has contact with part '" +
                              contact.part + "'; expected a scene without contact");
}

}  // namespace cable_variation
