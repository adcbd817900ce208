// What the compiler says of a description that cannot be right: a function for each rule, named after it.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// Rules of a description. chain() calls the function of the rule that is broken; none is constexpr, so the compiler
/// stops there, and its message is the function's name and whose rule it is (doc/guides/description_rules.md has the
/// bounds).
namespace malformed {

/// Whose rule is broken.
///@{
template <int Index>
struct link_index;  ///< a link, counted from 0 as parent() and q[] count
struct base_body;   ///< the body that is fixed to frame 0
struct robot;       ///< the robot as a whole
///@}

// One line per rule: the compiler shows it.
// clang-format off

// Numbers that mean nothing: never accepted.
template <class Of> void a_or_d_is_not_finite_give_metres() {}  ///< axial: a or d of a link is not finite; give it in metres
template <class Of> void alpha_or_theta_is_not_finite_give_radians() {}  ///< axial: alpha or theta of a link is not finite; give radians, or degrees with alpha_deg and theta_deg
template <class Of> void branch_is_not_finite_give_radians_and_metres() {}  ///< axial: gamma or b of a link's branch is not finite; give branch(radians, metres) or branch_deg(degrees, metres)
template <class Of> void parent_does_not_precede_list_links_from_the_base_outwards() {}  ///< axial: parent() of a link must name an earlier link or LinkParameters::base; list links from the base outwards
template <class Of> void mass_com_or_inertia_is_not_finite_give_kg_m_kg_m2() {}  ///< axial: mass, com or inertia of a link is not finite; give kg, m and kg m^2
template <class Of> void mass_is_negative_give_kg_of_0_or_more() {}  ///< axial: the mass of a link is negative; give kg >= 0, a massless link has mass(0.0)
template <class Of> void inertia_origin_precedes_mass_or_com_give_it_after_them() {}  ///< axial: inertia_origin() of a link stands before its mass or com; give it after them
template <class Of> void rotor_inertia_or_gear_is_no_value_give_kg_m2_and_gear_ratio() {}  ///< axial: rotor_inertia of a link is not finite, or its gear ratio not finite or 0 (1 / 100 of whole numbers is 0); give kg m^2 on the motor side and motor turns per joint turn
template <class Of> void rotor_inertia_is_negative_give_kg_m2_of_0_or_more() {}  ///< axial: rotor_inertia of a link is negative; give kg m^2 >= 0 on the motor side
template <class Of> void rotor_axis_is_no_direction_give_three_numbers_not_all_0() {}  ///< axial: rotor_axis of a link is no direction; give three finite numbers, not all 0
template <class Of> void rotor_carrier_does_not_precede_name_a_link_inboard() {}  ///< axial: the carrier of rotor_axis() must be an earlier link or LinkParameters::base; name a link inboard of the joint
template <class Of> void friction_is_not_finite_give_viscous_and_coulomb() {}  ///< axial: friction of a link is not finite; give viscous() and coulomb() on the joint side
template <class Of> void viscous_is_negative_give_0_or_more() {}  ///< axial: viscous friction of a link is negative and would feed energy in; give a value >= 0
template <class Of> void coulomb_feeds_energy_in_give_forward_of_0_or_more_and_backward_of_0_or_less() {}  ///< axial: coulomb friction of a link feeds energy in; give coulomb(forward >= 0, backward <= 0)
template <class Of> void stribeck_or_smooth_speed_is_not_finite_give_effort_and_speed() {}  ///< axial: stribeck or smooth_speed of a link is not finite; give stribeck(static_effort, speed)
template <class Of> void stribeck_effort_is_below_coulomb_give_the_larger() {}  ///< axial: the static effort of stribeck() is below the Coulomb friction of the link; give the larger
template <class Of> void stribeck_speed_is_too_small_give_1e_minus_9_or_more() {}  ///< axial: the speed of stribeck() must be at least 1e-9 rad/s or m/s
template <class Of> void smooth_speed_is_too_small_give_1e_minus_9_or_more() {}  ///< axial: smooth_speed of a link must be at least 1e-9 rad/s or m/s; leave it out for a step
template <class Of> void spring_is_not_finite_give_stiffness_and_rest_position() {}  ///< axial: spring of a link is not finite; give spring(stiffness, rest_position)
template <class Of> void stiffness_is_not_positive_give_more_than_0() {}  ///< axial: stiffness of a link's transmission must be > 0; leave it out where the joint is rigid
template <class Of> void position_limits_are_upside_down_give_min_below_max() {}  ///< axial: position_limits of a link are upside down; give position_limits(min, max) with min < max
template <class Of> void position_limits_deg_of_a_slide_give_position_limits_in_metres() {}  ///< axial: position_limits_deg() of a prismatic joint; give position_limits(min, max) in metres
template <class Of> void speed_limit_is_not_positive_give_more_than_0() {}  ///< axial: speed_limit of a link must be > 0
template <class Of> void acceleration_limit_is_not_positive_give_more_than_0() {}  ///< axial: acceleration_limit of a link must be > 0
template <class Of> void effort_limit_is_not_positive_give_more_than_0() {}  ///< axial: effort_limit of a link must be > 0
template <class Of> void added_mass_is_negative_or_not_finite_give_0_or_more() {}  ///< axial: added_mass of a link must be finite and >= 0; give kg and kg m^2 along the link's axes
template <class Of> void buoyancy_is_negative_or_not_finite_give_kg_of_water_and_metres() {}  ///< axial: buoyancy of a link must be finite and >= 0; give buoyancy(kg of water, x, y, z)
template <class Of> void drag_is_negative_or_not_finite_give_0_or_more() {}  ///< axial: drag of a link is negative and would feed energy in; give finite values >= 0
template <class Of> void gravity_is_not_finite_give_m_per_s2() {}  ///< axial: gravity is not finite; give gravity(x, y, z) in m/s^2
template <class Of> void base_or_tool_is_not_finite_give_metres_and_a_rotation() {}  ///< axial: base or tool pose is not finite; give metres and a rotation matrix
template <class Of> void base_or_tool_is_no_rotation_give_an_orthonormal_matrix() {}  ///< axial: base or tool rotation is not orthonormal; give a rotation matrix, row major
template <class Of> void payload_limit_is_negative_or_not_finite_give_0_or_more() {}  ///< axial: payload_limit must be finite and >= 0; give payload_limit(kg, m, kg m^2)
template <class Of> void tip_wrench_limit_is_negative_or_not_finite_give_0_or_more() {}  ///< axial: tip_wrench_limit must be finite and >= 0; give tip_wrench_limit(N, N m)
template <class Of> void tool_limit_is_negative_or_not_finite_give_0_or_more() {}  ///< axial: tool_limit must be finite and >= 0; give tool_limit(m)
template <class Of> void drive_ratio_is_not_finite_or_zero_give_a_ratio() {}  ///< axial: driven_by(), mimic() or a transmission of a link has a ratio that is 0 or not finite; give rad or m of the joint per unit of the drive
template <class Of> void drive_limits_are_upside_down_give_min_below_max_and_more_than_0() {}  ///< axial: drive_limits of a link are upside down or not positive; give drive_limits(min, max, speed > 0, acceleration > 0)
template <class Of> void drives_are_no_drives_of_the_chain_name_joints_that_have_one() {}  ///< axial: driven_by() or mimic() of a link names a joint that is not there, has no drive of its own, or follows this one; name one of the chain, counted from 0, six at most
template <class Of> void joint_without_drive_has_rotor_friction_or_limits_of_one_give_them_to_its_drive() {}  ///< axial: a joint without a drive of its own has rotor_inertia, friction, effort_limit or drive_limits; give them to the link whose drive moves it
template <class Of> void transmission_is_misplaced_put_it_behind_its_links() {}  ///< axial: screw_spline() stands behind a slide and a turn, differential() behind its two links, drive_ratios() of all joints behind all; no two of them on the same links
template <class Of> void drives_do_not_move_the_joints_independently_check_their_ratios() {}  ///< axial: some motion of the drives moves no joint, or some joint is moved by none; check the ratios of driven_by(), mimic() and transmissions

// Numbers that no robot has: .accept(axial::as_published) keeps them.
template <class Of> void a_is_beyond_100_m_give_metres() {}  ///< axial: a of a link is beyond 100 m; give metres, not millimetres, or .accept(axial::as_published)
template <class Of> void d_is_beyond_100_m_give_metres() {}  ///< axial: d of a link is beyond 100 m; give metres, not millimetres, or .accept(axial::as_published)
template <class Of> void b_of_branch_is_beyond_100_m_give_metres() {}  ///< axial: b of a link's branch is beyond 100 m; give metres, not millimetres, or .accept(axial::as_published)
template <class Of> void com_is_beyond_100_m_give_metres() {}  ///< axial: com of a link is beyond 100 m; give metres, not millimetres, or .accept(axial::as_published)
template <class Of> void buoyancy_centre_is_beyond_100_m_give_metres() {}  ///< axial: centre of buoyancy of a link is beyond 100 m; give metres, not millimetres, or .accept(axial::as_published)
template <class Of> void position_limits_are_beyond_100_m_give_metres() {}  ///< axial: position_limits of a prismatic joint are beyond 100 m; give metres, not millimetres, or .accept(axial::as_published)
template <class Of> void position_limits_are_beyond_1000_rad_give_radians_or_position_limits_deg() {}  ///< axial: position_limits of a revolute joint are beyond 1000 rad; give radians, or .accept(axial::as_published)
template <class Of> void position_limits_look_like_degrees_give_radians_or_position_limits_deg() {}  ///< axial: position_limits of a revolute joint look like degrees; give radians, position_limits_deg(min, max) or .accept(axial::as_published)
template <class Of> void alpha_is_beyond_one_turn_give_radians_or_alpha_deg() {}  ///< axial: alpha of a link is beyond one turn; give radians, or degrees with alpha_deg, or .accept(axial::as_published)
template <class Of> void theta_is_beyond_one_turn_give_radians_or_theta_deg() {}  ///< axial: theta of a link is beyond one turn; give radians, or degrees with theta_deg, or .accept(axial::as_published)
template <class Of> void gamma_of_branch_is_beyond_one_turn_give_radians_or_branch_deg() {}  ///< axial: gamma of a link's branch is beyond one turn; give radians, or degrees with branch_deg, or .accept(axial::as_published)
template <class Of> void mass_is_beyond_1000_kg_give_kilograms() {}  ///< axial: mass of a link is beyond 1000 kg; give kilograms, not grams, or .accept(axial::as_published)
template <class Of> void inertia_without_mass_give_mass() {}  ///< axial: inertia of a link without mass; give its mass in kg, or .accept(axial::as_published)
template <class Of> void com_without_mass_give_mass() {}  ///< axial: com of a link without mass; give its mass in kg, or .accept(axial::as_published)
template <class Of> void inertia_is_not_positive_definite_check_its_signs_and_order() {}  ///< axial: inertia of a link is not positive definite by more than 5 %; check signs and order of xx yy zz xy xz yz, or .accept(axial::as_published)
template <class Of> void inertia_breaks_the_triangle_inequality_check_its_entries() {}  ///< axial: inertia of a link breaks the triangle inequality by more than 5 %: no body has it; check its entries, or .accept(axial::as_published)
template <class Of> void base_is_beyond_100_m_give_metres() {}  ///< axial: base is beyond 100 m; give metres, not millimetres, or axial::accept(axial::as_published)
template <class Of> void tool_is_beyond_100_m_give_metres() {}  ///< axial: tool is beyond 100 m; give metres, not millimetres, or axial::accept(axial::as_published)
template <class Of> void payload_limit_reach_is_beyond_100_m_give_metres() {}  ///< axial: reach of payload_limit is beyond 100 m; give metres, not millimetres, or axial::accept(axial::as_published)
template <class Of> void tool_limit_is_beyond_100_m_give_metres() {}  ///< axial: tool_limit is beyond 100 m; give metres, not millimetres, or axial::accept(axial::as_published)

// A quantity that is given twice: .accept(axial::as_published) keeps the later one.
template <class Of> void a_is_given_twice_keep_one() {}  ///< axial: a of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void alpha_is_given_twice_keep_one() {}  ///< axial: alpha of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void d_is_given_twice_keep_one() {}  ///< axial: d of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void theta_is_given_twice_keep_one() {}  ///< axial: theta of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void mass_is_given_twice_keep_one() {}  ///< axial: mass of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void com_is_given_twice_keep_one() {}  ///< axial: com of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void inertia_is_given_twice_keep_one() {}  ///< axial: inertia of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void rotor_inertia_is_given_twice_keep_one() {}  ///< axial: rotor_inertia of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void rotor_axis_is_given_twice_keep_one() {}  ///< axial: rotor_axis of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void viscous_is_given_twice_keep_one() {}  ///< axial: viscous of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void coulomb_is_given_twice_keep_one() {}  ///< axial: coulomb of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void stribeck_is_given_twice_keep_one() {}  ///< axial: stribeck of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void smooth_speed_is_given_twice_keep_one() {}  ///< axial: smooth_speed of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void spring_is_given_twice_keep_one() {}  ///< axial: spring of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void stiffness_is_given_twice_keep_one() {}  ///< axial: stiffness of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void position_limits_are_given_twice_keep_one() {}  ///< axial: position_limits of a link are given twice; keep one, or .accept(axial::as_published)
template <class Of> void speed_limit_is_given_twice_keep_one() {}  ///< axial: speed_limit of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void acceleration_limit_is_given_twice_keep_one() {}  ///< axial: acceleration_limit of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void effort_limit_is_given_twice_keep_one() {}  ///< axial: effort_limit of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void parent_is_given_twice_keep_one() {}  ///< axial: parent of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void branch_is_given_twice_keep_one() {}  ///< axial: branch of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void added_mass_is_given_twice_keep_one() {}  ///< axial: added_mass of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void buoyancy_is_given_twice_keep_one() {}  ///< axial: buoyancy of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void drag_linear_is_given_twice_keep_one() {}  ///< axial: drag_linear of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void drag_quadratic_is_given_twice_keep_one() {}  ///< axial: drag_quadratic of a link is given twice; keep one, or .accept(axial::as_published)
template <class Of> void gravity_is_given_twice_keep_one() {}  ///< axial: gravity() is given twice; keep one, or axial::accept(axial::as_published)
template <class Of> void base_is_given_twice_keep_one() {}  ///< axial: base() is given twice; keep one, or axial::accept(axial::as_published)
template <class Of> void tool_is_given_twice_keep_one() {}  ///< axial: tool() is given twice; keep one, or axial::accept(axial::as_published)
template <class Of> void payload_limit_is_given_twice_keep_one() {}  ///< axial: payload_limit() is given twice; keep one, or axial::accept(axial::as_published)
template <class Of> void tip_wrench_limit_is_given_twice_keep_one() {}  ///< axial: tip_wrench_limit() is given twice; keep one, or axial::accept(axial::as_published)
template <class Of> void tool_limit_is_given_twice_keep_one() {}  ///< axial: tool_limit() is given twice; keep one, or axial::accept(axial::as_published)
template <class Of> void base_body_is_given_twice_keep_one() {}  ///< axial: base_body() is given twice; keep one, or axial::accept(axial::as_published)
// clang-format on

}  // namespace malformed
}  // namespace axial

#include <axial/options/end.hpp>
