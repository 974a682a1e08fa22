#include <link.h>
#include <verify/build_id.hpp>

#include <cstring>
#include <string_view>

namespace patchproof {

namespace {

constexpr std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

std::string hexadecimal(const unsigned char* bytes, std::size_t count) {
  static constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (std::size_t k = 0; k < count; ++k) {
    text += digits[bytes[k] >> 4U];
    text += digits[bytes[k] & 15U];
  }
  return text;
}

// The build id among the notes of a segment: each is a head, an owner and what is said, see elf(5).
std::string id_among(const unsigned char* notes, std::size_t size) {
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) head;
    std::memcpy(&head, notes, sizeof head);
    const std::size_t owner = sizeof head;
    const std::size_t said = owner + padded(head.n_namesz);
    const std::size_t end = said + padded(head.n_descsz);
    if (end > size) return "";
    if (head.n_type == NT_GNU_BUILD_ID && head.n_namesz == 4 &&
        std::memcmp(notes + owner, "GNU", 4) == 0)
      return hexadecimal(notes + said, head.n_descsz);
    notes += end;
    size -= end;
  }
  return "";
}

std::string id_of(const dl_phdr_info& object) {
  for (std::size_t k = 0; k < object.dlpi_phnum; ++k) {
    const ElfW(Phdr)& segment = object.dlpi_phdr[k];
    if (segment.p_type != PT_NOTE) continue;
    const std::string id =
        id_among(reinterpret_cast<const unsigned char*>(object.dlpi_addr + segment.p_vaddr),
                 segment.p_memsz);
    if (!id.empty()) return id;
  }
  return "";
}

// The first object is the program itself; without its id the others say nothing.
int add(dl_phdr_info* object, std::size_t, void* ids) {
  std::string& all = *static_cast<std::string*>(ids);
  const bool is_program = all.empty();
  const std::string id = id_of(*object);
  if (is_program && id.empty()) return 1;
  if (!id.empty()) all += (is_program ? "" : " ") + id;
  return 0;
}

}  // namespace

std::string build_id() {
  std::string ids;
  ::dl_iterate_phdr(add, &ids);
  return ids;
}

}  // namespace patchproof
