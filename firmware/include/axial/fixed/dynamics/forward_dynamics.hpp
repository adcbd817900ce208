// Forward dynamics in fixed point: which route it takes, how it looks at states.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/dynamics/forward_dynamics.hpp>
#include <axial/fixed/dynamics/driven_forward_dynamics.hpp>
#include <axial/fixed/dynamics/split_answer.hpp>
#include <axial/fixed/limits/state_check.hpp>
#include <axial/fixed/recursion/steps.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

/// An articulated body, of proved ranges, split unless named; composite bodies where joints share drives.
template <class S, class Word>
struct RouteOver<S, Stored<Word>> {
  static constexpr Route value = shares_drives_in<typename scene_of<S>::Robot> ? Route::composite_body
                                 : scene_of<S>::template has<ArticulatedBody>  ? Route::articulated_body
                                                                               : Route::split_articulated_body;
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
