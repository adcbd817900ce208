// The links of a robot as the algorithms walk over them, unrolled or looped.
#pragma once

#include <axial/model/link_view.hpp>

namespace axial {

/// All links of a scene's robot, each with its own type.
template <class SceneType, class ScalarType>
struct StaticLinks {
  using Scene = SceneType;
  using Scalar = ScalarType;
  static constexpr bool unrolled = true;
  static constexpr int capacity = Scene::Robot::chain.size;
  using Indices = std::make_integer_sequence<int, capacity>;

  static constexpr int size() { return capacity; }
  template <int I>
  static constexpr auto link(Index<I>) { return StaticLink<Scene, I, Scalar>{}; }
  template <int I>
  static constexpr int parent_of = Scene::Robot::chain.parent(I);
  template <int I>
  static constexpr auto parent(Index<I>) { return Index<parent_of<I>>{}; }
  /// Acceleration of the base that stands for gravity, -g in frame 0.
  static constexpr auto base_acceleration() {
    if constexpr (Scene::template has<Gravity>) {
      return Vec3{component<0>(), component<1>(), component<2>()};
    } else {
      return ZeroVec3{};
    }
  }

 private:
  template <int K>
  static constexpr auto component() {
    constexpr GravityVector g = Scene::Robot::chain.gravity;
    constexpr double value = K == 0 ? -g.x : K == 1 ? -g.y : -g.z;
    if constexpr (value == 0.0) return Zero{};
    else return NumberTraits<Scalar>::constant(value);
  }
};

/// A table of links with one type for all; the table may be constexpr, or filled at run time.
template <class SceneType, class ScalarType, class Source, int Capacity>
class TableLinks {
 public:
  using Scene = SceneType;
  using Scalar = ScalarType;
  static constexpr bool unrolled = false;
  static constexpr int capacity = Capacity;

  constexpr TableLinks(const LinkConstants<Source>* table, int size, const Vec3<Scalar>& gravity)
      : table_(table), size_(size), gravity_(gravity) {}

  constexpr int size() const { return size_; }
  constexpr auto link(int i) const { return TableLink<Scene, Scalar, Source>(table_[i], i + 1 == size_); }
  constexpr int parent(int i) const { return table_[i].parent; }
  constexpr Vec3<Scalar> base_acceleration() const {
    if constexpr (Scene::template has<Gravity>) return -gravity_;
    else return ZeroVec3{};
  }

 private:
  const LinkConstants<Source>* table_;
  int size_;
  Vec3<Scalar> gravity_;
};

namespace detail {

template <class Robot, class T, int... I>
constexpr auto converted_table(std::integer_sequence<int, I...>) {
  struct Table {
    LinkConstants<T> links[sizeof...(I)];
  };
  return Table{{converted<T>(robot_constants<Robot>.links[I])...}};
}
template <class Robot, class T>
inline constexpr auto robot_table = converted_table<Robot, T>(std::make_integer_sequence<int, Robot::chain.size>{});

}  // namespace detail

/// The links of a scene (or of a bare robot) over numbers T, in the form that the scene asks for.
template <class S, class T>
constexpr auto links_of() {
  using Scene = scene_of<S>;
  using Robot = typename Scene::Robot;
  if constexpr (Scene::template has<Looped>) {
    constexpr GravityVector g = Robot::chain.gravity;
    using N = NumberTraits<T>;
    return TableLinks<Scene, T, T, Robot::chain.size>(detail::robot_table<Robot, T>.links, Robot::chain.size,
                                                     {N::constant(g.x), N::constant(g.y), N::constant(g.z)});
  } else {
    return StaticLinks<Scene, T>{};
  }
}

}  // namespace axial
