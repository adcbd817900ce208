// A hand-made ELF file with one section of each kind that a firmware image has.
#include <host_sim/tools/analysis/image_size.hpp>

#include <host_sim/plants/temporary_file.hpp>

#include <gtest/gtest.h>

#include <cstring>
#include <stdexcept>

#include <elf.h>

namespace {

using host_sim::test::TemporaryFile;

const char names[] = "\0.text\0.data\0.bss\0.stack\0.debug\0.names";
constexpr Elf32_Word text = 1, data = 7, bss = 13, stack = 18, debug = 25, name_table = 32;

Elf32_Shdr section(Elf32_Word name, Elf32_Word type, Elf32_Word flags, Elf32_Word size) {
  Elf32_Shdr header{};
  header.sh_name = name;
  header.sh_type = type;
  header.sh_flags = flags;
  header.sh_size = size;
  return header;
}

std::string elf_file() {
  Elf32_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS32;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
  Elf32_Shdr sections[] = {section(text, SHT_PROGBITS, SHF_ALLOC | SHF_EXECINSTR, 1000),
                           section(data, SHT_PROGBITS, SHF_ALLOC | SHF_WRITE, 40),
                           section(bss, SHT_NOBITS, SHF_ALLOC | SHF_WRITE, 500),
                           section(stack, SHT_NOBITS, SHF_ALLOC | SHF_WRITE, 4096),
                           section(debug, SHT_PROGBITS, 0, 99999),
                           section(name_table, SHT_STRTAB, 0, sizeof names)};
  sections[5].sh_offset = sizeof header;
  header.e_shoff = sizeof header + sizeof names;
  header.e_shentsize = sizeof(Elf32_Shdr);
  header.e_shnum = 6;
  header.e_shstrndx = 5;
  std::string file(reinterpret_cast<const char*>(&header), sizeof header);
  file.append(names, sizeof names);
  return file.append(reinterpret_cast<const char*>(sections), sizeof sections);
}

TEST(ImageSize, FlashHoldsCodeAndInitialData) {
  const TemporaryFile file(".elf", elf_file());
  EXPECT_EQ(host_sim::image_size(file.path()).flash, 1040u);
}

TEST(ImageSize, RamHoldsDataButNotTheReservedStack) {
  const TemporaryFile file(".elf", elf_file());
  EXPECT_EQ(host_sim::image_size(file.path()).ram, 540u);
}

TEST(ImageSize, RefusesOtherFiles) {
  const TemporaryFile empty(".elf", ""), words(".elf", std::string(200, 'x')), cut(".elf", elf_file().substr(0, 150));
  for (const auto* file : {&empty, &words, &cut})
    EXPECT_THROW(host_sim::image_size(file->path()), std::runtime_error);
}

}  // namespace
