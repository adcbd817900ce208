#pragma once
/// Registers that note every store, in order.

#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace axial::hal {

using Store = std::pair<std::string_view, std::uint32_t>;

/// What was stored since `stores_of` began.
inline std::vector<Store> noted;

struct Noted {
  const char* name;
  std::uint32_t written = 0;
  /// What a read gives, from what was written last.
  std::function<std::uint32_t(std::uint32_t)> answer{};
  void operator=(std::uint32_t value) {
    noted.emplace_back(name, value);
    written = value;
  }
  operator std::uint32_t() const { return answer ? answer(written) : written; }
};

template <class Code>
std::vector<Store> stores_of(Code code) {
  noted.clear();
  code();
  return noted;
}

}  // namespace axial::hal
