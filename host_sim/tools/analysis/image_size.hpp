// Memory of a firmware image, from its ELF file.
#pragma once

#include <cstdint>
#include <string>

namespace host_sim {

struct ImageSize {
  std::uint32_t flash = 0;  ///< bytes: code, constants and the initial values of data
  std::uint32_t ram = 0;    ///< bytes: data and zero-initialised data, without the reserved stack
};

/// Throws std::runtime_error when the file is no 32-bit little-endian ELF.
ImageSize image_size(const std::string& path);

}  // namespace host_sim
