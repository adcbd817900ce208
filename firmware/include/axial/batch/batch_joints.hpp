// From joint values of one state after the other to batches, and back.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/scalar/batch.hpp>
#include <axial/scalar/lanes.hpp>
#include <axial/scene/joints.hpp>

#include <axial/options/begin.hpp>

namespace axial {
namespace detail {

/// Keeps x as it is, in one register. Clang stores halves of what shuffles make, and a processor waits where a kernel
/// reads them as one.
template <class Vector>
AXIAL_INLINE inline void keep_whole(Vector& x) {
#if defined(__clang__) && defined(__x86_64__)
  asm("" : "+x"(x));
#else
  static_cast<void>(x);
#endif
}

/// Moves the values of `Width` states between rows (a state's values) and columns (a joint's lanes): squares of them in
/// registers, the last one overlapping the one before; a robot with fewer joints than lanes value by value.
template <class Joints, class Lanes, int First>
struct Columns {
  static constexpr int width = lanes_of_vector<Lanes>(), joints = Joints::size;
  using Indices = std::make_integer_sequence<int, width>;
  using Vector = std::decay_t<decltype(vector_from<0>(std::declval<Lanes&>()))>;

  template <int Joint, class Batches, int... I>
  AXIAL_INLINE static constexpr void load(const Joints* states, Batches& batches, std::integer_sequence<int, I...>) {
    if constexpr (joints < width) {
      Vector column{states[First + I][Joint]...};
      keep_whole(column);
      vector_from<First>(batches[Joint].lanes) = column;
      if constexpr (Joint + 1 < joints) load<Joint + 1>(states, batches, Indices{});
    } else {
      Vector rows[width];
      (__builtin_memcpy(&rows[I], &states[First + I].values[Joint], sizeof(Vector)), ...);
      transpose(rows);
      (keep_whole(rows[I]), ...);
      ((vector_from<First>(batches[Joint + I].lanes) = rows[I]), ...);
      if constexpr (Joint + width < joints) load<next(Joint)>(states, batches, Indices{});
    }
  }
  template <int Joint, class Batches, int... I>
  AXIAL_INLINE static constexpr void store(const Batches& batches, Joints* states, std::integer_sequence<int, I...>) {
    if constexpr (joints < width) {
      ((states[First + I][Joint] = vector_from<First>(batches[Joint].lanes)[I]), ...);
      if constexpr (Joint + 1 < joints) store<Joint + 1>(batches, states, Indices{});
    } else {
      Vector rows[width] = {vector_from<First>(batches[Joint + I].lanes)...};
      transpose(rows);
      (__builtin_memcpy(&states[First + I].values[Joint], &rows[I], sizeof(Vector)), ...);
      if constexpr (Joint + width < joints) store<next(Joint)>(batches, states, Indices{});
    }
  }
  static constexpr int next(int joint) { return joint + 2 * width <= joints ? joint + width : joints - width; }
};

template <int First, class Joints, class Batches>
AXIAL_INLINE constexpr void load_from(const Joints* states, Batches& batches) {
  using Lanes = typename std::decay_t<decltype(batches[0])>::Lanes;
  if constexpr (First < Lanes::size) {
    using Part = Columns<Joints, Lanes, First>;
    Part::template load<0>(states, batches, typename Part::Indices{});
    load_from<First + Part::width>(states, batches);
  }
}
template <int First, class Joints, class Batches>
AXIAL_INLINE constexpr void store_from(const Batches& batches, Joints* states) {
  using Lanes = typename std::decay_t<decltype(batches[0])>::Lanes;
  if constexpr (First < Lanes::size) {
    using Part = Columns<Joints, Lanes, First>;
    Part::template store<0>(batches, states, typename Part::Indices{});
    store_from<First + Part::width>(batches, states);
  }
}

}  // namespace detail

/// Joint values of the N states at `states`, `states + 1`, ... as one batch per joint; N that of a vector register
/// unless given: `load<4>(states)`. Nothing behind the N-th is read.
template <int N = 0, class S, class T>
[[nodiscard]] AXIAL_INLINE constexpr auto load(const Joints<S, T, void>* states) {
  Joints<S, Batch<T, N == 0 ? native_lanes<T> : N>> batches{};
  detail::load_from<0>(states, batches);
  return batches;
}
/// The reverse of load(): writes the N states at `states`.
template <class S, class T, int N, int Bytes>
AXIAL_INLINE constexpr void store(const Joints<S, Batch<T, N, Bytes>, void>& batches, Joints<S, T, void>* states) {
  detail::store_from<0>(batches, states);
}

/// Joint values of one lane; the index is not checked.
template <class S, class T, int N, int Bytes>
[[nodiscard]] constexpr Joints<S, T> lane(const Joints<S, Batch<T, N, Bytes>, void>& batches, int lane) {
  Joints<S, T> state{};
  for (int i = 0; i < batches.size; ++i)
    state[i] = batches[i][lane];
  return state;
}

}  // namespace axial

#include <axial/options/end.hpp>
