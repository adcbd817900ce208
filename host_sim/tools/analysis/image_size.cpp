#include <host_sim/tools/analysis/image_size.hpp>

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include <elf.h>

namespace host_sim {

namespace {

using Bytes = std::vector<char>;

template <class Struct>
Struct read_at(const Bytes& file, std::size_t offset) {
  Struct value;
  if (offset > file.size() || file.size() - offset < sizeof value) throw std::runtime_error("truncated ELF file");
  std::memcpy(&value, file.data() + offset, sizeof value);
  return value;
}

std::string section_name(const Bytes& file, const Elf32_Shdr& names, const Elf32_Shdr& section) {
  std::string name;
  for (std::size_t at = names.sh_offset + section.sh_name; at < file.size() && file[at] != '\0'; ++at)
    name += file[at];
  return name;
}

Elf32_Ehdr read_header(const Bytes& file) {
  const auto header = read_at<Elf32_Ehdr>(file, 0);
  const bool expected = std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 && header.e_ident[EI_CLASS] == ELFCLASS32 &&
                        header.e_ident[EI_DATA] == ELFDATA2LSB;
  if (!expected) throw std::runtime_error("no 32-bit little-endian ELF file");
  return header;
}

ImageSize size_of(const Bytes& file) {
  const auto header = read_header(file);
  const auto section = [&](std::size_t i) {
    return read_at<Elf32_Shdr>(file, header.e_shoff + i * header.e_shentsize);
  };
  const auto names = section(header.e_shstrndx);
  ImageSize size;
  for (std::size_t i = 0; i < header.e_shnum; ++i) {
    const auto s = section(i);
    if ((s.sh_flags & SHF_ALLOC) == 0 || section_name(file, names, s) == ".stack") continue;
    if (s.sh_type != SHT_NOBITS) size.flash += s.sh_size;
    if ((s.sh_flags & SHF_WRITE) != 0) size.ram += s.sh_size;
  }
  return size;
}

}  // namespace

ImageSize image_size(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const Bytes bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  try {
    return size_of(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace host_sim
