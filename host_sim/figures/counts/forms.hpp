// The forms of forward dynamics that are counted, each with the scene that takes it.
#pragma once

#include <axial/dynamics/route.hpp>

namespace counts {

template <class S>
struct Form {
  using Scene = S;
  const char* algorithm;
  const char* parameters;
};

constexpr const char* name_of(axial::Route route) {
  switch (route) {
    case axial::Route::split_articulated_body:
      return "split_articulated_body";
    case axial::Route::composite_body:
      return "composite_body";
    default:
      return "articulated_body";
  }
}

/// Scenes of a bare robot: gravity, and rotors where it declares them.
template <class R, class... Features>
using Bare = axial::Scene<R, axial::Gravity, axial::RotorInertia, Features...>;

/// Whether joints of a robot share drives: articulated bodies are then clusters, by the split form alone, and no joint
/// has a spring before it.
template <class R>
inline constexpr bool shares_drives = axial::detail::shares_drives_in<typename axial::scene_of<R>::Robot>;

/// Calls visit(Form<Scene>{algorithm, parameters}) for each. The split form's bias torque is on base parameters always.
template <class R, class Visit>
void for_each_form(const Visit& visit) {
  using namespace axial;
  if constexpr (!shares_drives<R>) {
    visit(Form<Bare<R, ArticulatedBody>>{"articulated_body", "full"});
    visit(Form<Bare<R, ArticulatedBody, BaseParameters>>{"articulated_body", "base"});
  }
  visit(Form<Bare<R, SplitArticulatedBody>>{"split_articulated_body", "full"});
  if constexpr (!shares_drives<R>)
    visit(Form<Bare<R, SplitArticulatedBody, BaseParameters>>{"split_articulated_body", "base"});
  visit(Form<Bare<R, CompositeBody, FullParameters>>{"composite_body", "full"});
  visit(Form<Bare<R, CompositeBody>>{"composite_body", "base"});
}

}  // namespace counts
