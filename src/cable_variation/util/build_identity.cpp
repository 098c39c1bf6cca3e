#include <cable_variation/util/build_identity.h>

#include <cstdint>
#include <cstdio>
#include <cstring>

#include <elf.h>
#include <link.h>

#if defined(__GLIBC__)
#include <gnu/libc-version.h>
#endif

#include <cable_variation/util/version.h>

namespace cable_variation {

namespace {

struct Search {
  std::uintptr_t inside;  // an address in the library
  std::string identifier;
};

bool holds(const dl_phdr_info& object, std::uintptr_t address) {
  for (int i = 0; i < object.dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = object.dlpi_phdr[i];
    const std::uintptr_t start = object.dlpi_addr + part.p_vaddr;
    if (part.p_type == PT_LOAD && address >= start && address < start + part.p_memsz) return true;
  }
  return false;
}

// A note: lengths of its name and its content, a type, then both, each filled up to four bytes.
std::string identifierIn(const char* notes, std::size_t size) {
  const auto filled = [](std::size_t length) { return (length + 3) / 4 * 4; };
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes, sizeof note);
    const std::size_t content = sizeof note + filled(note.n_namesz);
    const std::size_t whole = content + filled(note.n_descsz);
    if (whole > size) break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == sizeof "GNU" &&
        std::memcmp(notes + sizeof note, "GNU", sizeof "GNU") == 0) {
      std::string digits;
      for (std::size_t i = 0; i < note.n_descsz; ++i) {
        char two[3];
        std::snprintf(two, sizeof two, "%02x", static_cast<unsigned char>(notes[content + i]));
        digits += two;
      }
      return digits;
    }
    notes += whole;
    size -= whole;
  }
  return "";
}

int look(dl_phdr_info* object, std::size_t /*size*/, void* data) {
  Search& search = *static_cast<Search*>(data);
  if (!holds(*object, search.inside)) return 0;
  for (int i = 0; i < object->dlpi_phnum && search.identifier.empty(); ++i) {
    const ElfW(Phdr)& part = object->dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    search.identifier =
        identifierIn(reinterpret_cast<const char*>(object->dlpi_addr + part.p_vaddr), part.p_memsz);
  }
  return 1;
}

}  // namespace

std::string buildIdentity() {
  static const char kHere = 0;
  Search search{reinterpret_cast<std::uintptr_t>(&kHere), ""};
  ::dl_iterate_phdr(look, &search);
  std::string text = packageVersion();
  return search.identifier.empty() ? text : text + " (build " + search.identifier + ")";
}

std::string machineIdentity() {
  std::string text = "processor";
#if defined(__x86_64__)
  text += " x86-64";
  if (__builtin_cpu_supports("avx2")) text += " avx2";
  if (__builtin_cpu_supports("fma")) text += " fma";
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) text += " avx512";
#elif defined(__aarch64__)
  text += " aarch64";
#endif
#if defined(__GLIBC__)
  text += std::string(", glibc ") + ::gnu_get_libc_version();
#endif
  return text;
}

}  // namespace cable_variation
