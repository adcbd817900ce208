/// What stands before the vector table.

#include <hal/rp2040/boot2.hpp>

namespace axial::hal::rp2040 {
namespace {

[[gnu::section(".boot"), gnu::used]] constexpr auto second_stage = boot2();

}  // namespace
}  // namespace axial::hal::rp2040
