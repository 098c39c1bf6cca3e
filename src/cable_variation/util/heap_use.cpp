#include <cable_variation/util/heap_use.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include <malloc.h>

namespace cable_variation {

namespace {

/// `size` of the last element of a kind, such as the text <total type="rest" count="2" size="300"/>.
std::optional<std::size_t> sizeOf(const std::string& kind, const std::string& text) {
  const std::size_t element = text.rfind("<" + kind);
  const std::size_t size = element == std::string::npos ? element : text.find("size=\"", element);
  if (size == std::string::npos) return std::nullopt;
  return std::strtoull(text.c_str() + size + 6, nullptr, 10);
}

std::string mallocInfo() {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* stream = open_memstream(&text, &size);
  if (stream == nullptr) return "";
  const bool told = malloc_info(0, stream) == 0;
  std::fclose(stream);
  std::string info = told ? std::string(text, size) : "";
  std::free(text);  // NOLINT: open_memstream's
  return info;
}

}  // namespace

std::optional<HeapUse> heapUse() {
  const std::string info = mallocInfo();  // its last elements are the sums over all arenas
  const auto fast = sizeOf("total type=\"fast\"", info), rest = sizeOf("total type=\"rest\"", info);
  const auto mapped = sizeOf("total type=\"mmap\"", info), arenas = sizeOf("system type=\"current\"", info);
  if (!fast || !rest || !mapped || !arenas) return std::nullopt;
  return HeapUse{*arenas - *fast - *rest + *mapped, *arenas + *mapped};
}

}  // namespace cable_variation
