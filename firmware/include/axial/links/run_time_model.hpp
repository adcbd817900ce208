// The name of a run-time model, for what takes one and needs no more of it.
#pragma once

#include <axial/scene/scene.hpp>

#include <axial/options/begin.hpp>

namespace axial {

template <int N, class... Features>
class Model;  // model.hpp

/// Whether a type is a run-time Model.
template <class T>
struct IsModel : std::false_type {};
/// A run-time Model is one.
template <int N, class... Features>
struct IsModel<Model<N, Features...>> : std::true_type {};

namespace detail {
template <int N, class... Features>
struct SceneOf<Model<N, Features...>> : SceneOf<typename Model<N, Features...>::Scene> {};
}  // namespace detail

}  // namespace axial

#include <axial/options/end.hpp>
