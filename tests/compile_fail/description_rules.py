"""The rules of a description: a row has the function of axial::malformed that the compiler names, the quantity, its bound, whose it is in the
compiler's message, parts of a chain just beyond the bound and parts just inside. Parts that begin with "classical" make a classical_chain().
"""

import collections

ONE = "revolute().mass(1)"
Rule = collections.namedtuple("Rule", "name what bound of broken sound")
NAN = "std::numeric_limits<double>::quiet_NaN()"
FOREVER = "std::numeric_limits<double>::infinity()"


def link(name, what, bound, broken, sound):
    """A rule for one link: the second of three."""
    if broken.startswith("classical"):
        return Rule(name, what, bound, "link_index<1>", f"classical_revolute(), {broken}", f"classical_revolute(), {sound}")
    return Rule(name, what, bound, "link_index<1>", f"{ONE}, {broken}, {ONE}", f"{ONE}, {sound}, {ONE}")


def robot(name, what, bound, broken, sound):
    return Rule(name, what, bound, "robot", f"{ONE}, {broken}", f"{ONE}, {sound}")


def twice(name, call, other=None):
    """Of a link's quantity: given once by every name, twice by two."""
    what = name.replace("_are_", "_is_").split("_is_")[0]
    other = other or call
    return link(name, what, "once", f"{ONE}{call}{other}" if what != "mass" else f"revolute(){call}{other}",
                f"{ONE}{other}" if what != "mass" else f"revolute(){other}")


def part_twice(name, call):
    return robot(name, name.split("_is_")[0] + "()", "once", f"{call}, {call}", call)


# What means nothing.
STRUCTURAL = [
    link("a_or_d_is_not_finite_give_metres", "a, d", "finite", f"{ONE}.a({NAN})", f"{ONE}.a(0)"),
    link("a_or_d_is_not_finite_give_metres", "a, d", "finite", f"{ONE}.d({FOREVER})", f"{ONE}.d(0)"),
    link("alpha_or_theta_is_not_finite_give_radians", "alpha, theta", "finite", f"{ONE}.alpha({NAN})", f"{ONE}.alpha(0.5)"),
    link("alpha_or_theta_is_not_finite_give_radians", "alpha, theta", "finite", f"{ONE}.theta_deg({FOREVER})", f"{ONE}.theta_deg(45)"),
    link("alpha_or_theta_is_not_finite_give_radians", "alpha, theta", "finite", f"classical_revolute().alpha({FOREVER})",
         "classical_revolute().alpha(0.5)"),
    link("branch_is_not_finite_give_radians_and_metres", "branch", "finite", f"{ONE}.branch({NAN}, 0)", f"{ONE}.branch(0, 0)"),
    link("branch_is_not_finite_give_radians_and_metres", "branch", "finite", f"{ONE}.branch(0, {NAN})", f"{ONE}.branch(0, 0)"),
    link("parent_does_not_precede_list_links_from_the_base_outwards", "parent", "an earlier link, or the base", f"{ONE}.parent(1)",
         f"{ONE}.parent(0)"),
    link("parent_does_not_precede_list_links_from_the_base_outwards", "parent", "an earlier link, or the base", f"{ONE}.parent(-3)",
         f"{ONE}.parent(-1)"),
    link("mass_com_or_inertia_is_not_finite_give_kg_m_kg_m2", "mass, com, inertia", "finite", f"revolute().mass({NAN})",
         "revolute().mass(1)"),
    link("mass_com_or_inertia_is_not_finite_give_kg_m_kg_m2", "mass, com, inertia", "finite", f"{ONE}.com(0, {NAN}, 0)",
         f"{ONE}.com(0, 0, 0)"),
    link("mass_com_or_inertia_is_not_finite_give_kg_m_kg_m2", "mass, com, inertia", "finite", f"{ONE}.inertia_com(1, 1, 1, 0, 0, {FOREVER})",
         f"{ONE}.inertia_com(1, 1, 1, 0, 0, 0.1)"),
    link("mass_is_negative_give_kg_of_0_or_more", "mass", ">= 0", "revolute().mass(-1e-9)", "revolute().mass(0)"),
    Rule("mass_is_negative_give_kg_of_0_or_more", "mass", ">= 0", "base_body", f"{ONE}, base_body().mass(-1)", f"{ONE}, base_body().mass(1)"),
    link("inertia_origin_precedes_mass_or_com_give_it_after_them", "inertia_origin", "after mass and com",
         "revolute().inertia_origin(1, 1, 1).mass(1)", "revolute().mass(1).inertia_origin(1, 1, 1)"),
    link("inertia_origin_precedes_mass_or_com_give_it_after_them", "inertia_origin", "after mass and com",
         f"{ONE}.inertia_origin(1, 1, 1).com(0.1, 0, 0)", f"{ONE}.com(0.1, 0, 0).inertia_origin(1, 1, 1)"),
    link("rotor_inertia_is_not_finite_give_kg_m2_and_gear_ratio", "rotor_inertia", "finite", f"{ONE}.rotor_inertia(1, {NAN})",
         f"{ONE}.rotor_inertia(1, -1)"),
    link("rotor_inertia_is_negative_give_kg_m2_of_0_or_more", "rotor_inertia", ">= 0", f"{ONE}.rotor_inertia(-1e-9)", f"{ONE}.rotor_inertia(0)"),
    link("rotor_axis_is_no_direction_give_three_numbers_not_all_0", "rotor_axis", "finite, not all 0", f"{ONE}.rotor_axis(0, 0, 0)",
         f"{ONE}.rotor_axis(0, 0, 1e-9)"),
    link("rotor_carrier_does_not_precede_name_a_link_inboard", "rotor_axis", "on an earlier link or the base",
         f"{ONE}.rotor_axis(0, 0, 1, 1)", f"{ONE}.rotor_axis(0, 0, 1, axial::LinkParameters::base)"),
    link("friction_is_not_finite_give_viscous_and_coulomb", "viscous, coulomb", "finite", f"{ONE}.coulomb({NAN})", f"{ONE}.coulomb(0)"),
    link("viscous_is_negative_give_0_or_more", "viscous", ">= 0", f"{ONE}.viscous(-1e-9)", f"{ONE}.viscous(0)"),
    link("coulomb_feeds_energy_in_give_forward_of_0_or_more_and_backward_of_0_or_less", "coulomb", "forward >= 0, backward <= 0",
         f"{ONE}.coulomb(-1e-9, 0)", f"{ONE}.coulomb(0, 0)"),
    link("coulomb_feeds_energy_in_give_forward_of_0_or_more_and_backward_of_0_or_less", "coulomb", "forward >= 0, backward <= 0",
         f"{ONE}.coulomb(1, 1e-9)", f"{ONE}.coulomb(1, -1)"),
    link("stribeck_or_smooth_speed_is_not_finite_give_effort_and_speed", "stribeck, smooth_speed", "finite", f"{ONE}.smooth_speed({NAN})",
         f"{ONE}.smooth_speed(0.1)"),
    link("stribeck_effort_is_below_coulomb_give_the_larger", "stribeck", "at least coulomb", f"{ONE}.coulomb(1).stribeck(0.99, 1)",
         f"{ONE}.coulomb(1).stribeck(1, 1)"),
    link("stribeck_speed_is_too_small_give_1e_minus_9_or_more", "stribeck", "speed of 1e-9 rad/s or m/s", f"{ONE}.stribeck(1, 0.99e-9)",
         f"{ONE}.stribeck(1, 1e-9)"),
    link("smooth_speed_is_too_small_give_1e_minus_9_or_more", "smooth_speed", "0, or 1e-9 rad/s or m/s", f"{ONE}.smooth_speed(0.99e-9)",
         f"{ONE}.smooth_speed(1e-9)"),
    link("spring_is_not_finite_give_stiffness_and_rest_position", "spring", "finite", f"{ONE}.spring(1, {FOREVER})", f"{ONE}.spring(1, 1)"),
    link("stiffness_is_not_positive_give_more_than_0", "stiffness", "> 0", f"{ONE}.stiffness(0)", f"{ONE}.stiffness(1e-3)"),
    link("stiffness_is_not_positive_give_more_than_0", "stiffness", "> 0", f"{ONE}.stiffness({NAN})", f"{ONE}.stiffness({FOREVER})"),
    link("position_limits_are_upside_down_give_min_below_max", "position_limits", "min < max", f"{ONE}.position_limits(1, 1)",
         f"{ONE}.position_limits(1, 1.001)"),
    link("position_limits_are_upside_down_give_min_below_max", "position_limits", "min < max", f"{ONE}.position_limits({NAN}, 1)",
         f"{ONE}.position_limits(-{FOREVER}, 1)"),
    link("position_limits_deg_of_a_slide_give_position_limits_in_metres", "position_limits_deg", "revolute joints",
         "prismatic().mass(1).position_limits_deg(-9, 9)", "revolute().mass(1).position_limits_deg(-180, 180)"),
    link("speed_limit_is_not_positive_give_more_than_0", "speed_limit", "> 0", f"{ONE}.speed_limit(0)", f"{ONE}.speed_limit(1e-9)"),
    link("speed_limit_is_not_positive_give_more_than_0", "speed_limit", "> 0", f"{ONE}.speed_limit({NAN})", f"{ONE}.speed_limit(1)"),
    link("acceleration_limit_is_not_positive_give_more_than_0", "acceleration_limit", "> 0", f"{ONE}.acceleration_limit(0)",
         f"{ONE}.acceleration_limit(1e-9)"),
    link("effort_limit_is_not_positive_give_more_than_0", "effort_limit", "> 0", f"{ONE}.effort_limit(-1)", f"{ONE}.effort_limit(1e-9)"),
    link("added_mass_is_negative_or_not_finite_give_0_or_more", "added_mass", ">= 0", f"{ONE}.added_mass(0, 0, 0, 0, -1e-9)",
         f"{ONE}.added_mass(0, 0, 0)"),
    link("buoyancy_is_negative_or_not_finite_give_kg_of_water_and_metres", "buoyancy", ">= 0", f"{ONE}.buoyancy(-1e-9, 0, 0, 0)",
         f"{ONE}.buoyancy(0, 0, 0, 0)"),
    link("drag_is_negative_or_not_finite_give_0_or_more", "drag_linear, drag_quadratic", ">= 0", f"{ONE}.drag_linear(0, 0, -1e-9)",
         f"{ONE}.drag_linear(0, 0, 0)"),
    link("drag_is_negative_or_not_finite_give_0_or_more", "drag_linear, drag_quadratic", ">= 0", f"{ONE}.drag_quadratic(0, {NAN}, 0)",
         f"{ONE}.drag_quadratic(0, 0, 0)"),
    robot("gravity_is_not_finite_give_m_per_s2", "gravity()", "finite", f"gravity(0, 0, {NAN})", "gravity(0, 0, 0)"),
    robot("base_or_tool_is_not_finite_give_metres_and_a_rotation", "base(), tool()", "finite", f"base(0, {NAN}, 0)", "base(0, 0, 0)"),
    robot("base_or_tool_is_no_rotation_give_an_orthonormal_matrix", "base(), tool()", "a rotation matrix to 1e-6",
          "tool(FixedPose{{1, 0, 0, 0, 1.000001, 0, 0, 0, 1}, {0, 0, 0}})", "tool(FixedPose{{1, 0, 0, 0, 1.0000001, 0, 0, 0, 1}, {0, 0, 0}})"),
    robot("payload_limit_is_negative_or_not_finite_give_0_or_more", "payload_limit()", ">= 0", "payload_limit(-1e-9, 0, 0)",
          "payload_limit(0, 0, 0)"),
    robot("tip_wrench_limit_is_negative_or_not_finite_give_0_or_more", "tip_wrench_limit()", ">= 0", f"tip_wrench_limit(0, {NAN})",
          "tip_wrench_limit(0, 0)"),
]

# What no robot has: .accept(axial::as_published) keeps it.
DOUBTFUL = [
    link("a_is_beyond_100_m_give_metres", "a", "100 m", f"{ONE}.a(-100.1)", f"{ONE}.a(-99.9)"),
    link("a_is_beyond_100_m_give_metres", "a", "100 m", "classical_revolute().a(100.1)", "classical_revolute().a(99.9)"),
    link("d_is_beyond_100_m_give_metres", "d", "100 m", f"{ONE}.d(100.1)", f"{ONE}.d(99.9)"),
    link("b_of_branch_is_beyond_100_m_give_metres", "branch", "b of 100 m", f"{ONE}.branch(0, 100.1)", f"{ONE}.branch(0, 99.9)"),
    link("com_is_beyond_100_m_give_metres", "com", "100 m", f"{ONE}.com(0, 0, -100.1)", f"{ONE}.com(99.9, -99.9, 99.9)"),
    link("buoyancy_centre_is_beyond_100_m_give_metres", "buoyancy", "centre at 100 m", f"{ONE}.buoyancy(1, 0, 100.1, 0)",
         f"{ONE}.buoyancy(1, 0, 99.9, 0)"),
    link("position_limits_are_beyond_100_m_give_metres", "position_limits of a prismatic joint", "100 m",
         "prismatic().mass(1).position_limits(-1, 100.1)", "prismatic().mass(1).position_limits(-99.9, 99.9)"),
    link("position_limits_are_beyond_1000_rad_give_radians_or_position_limits_deg", "position_limits of a revolute joint", "1000 rad",
         f"{ONE}.position_limits(-1000.1, 1)", f"{ONE}.position_limits(-999.9, 999.9)"),
    link("position_limits_are_beyond_1000_rad_give_radians_or_position_limits_deg", "position_limits of a revolute joint", "1000 rad",
         f"{ONE}.position_limits(1, 1001)", f"{ONE}.position_limits(-999, 999)"),
    link("position_limits_look_like_degrees_give_radians_or_position_limits_deg", "position_limits of a revolute joint",
         "not two whole numbers of which the larger is 90 to 400, 100, 200, 300 and 400 apart", f"{ONE}.position_limits(-180, 180)",
         f"{ONE}.position_limits(-100, 100)"),
    link("position_limits_look_like_degrees_give_radians_or_position_limits_deg", "position_limits of a revolute joint",
         "not two whole numbers of which the larger is 90 to 400, 100, 200, 300 and 400 apart", f"{ONE}.position_limits(-1, 90)",
         f"{ONE}.position_limits(-1, 89)"),
    link("position_limits_look_like_degrees_give_radians_or_position_limits_deg", "position_limits of a revolute joint",
         "not two whole numbers of which the larger is 90 to 400, 100, 200, 300 and 400 apart", f"{ONE}.position_limits(-399, 30)",
         f"{ONE}.position_limits(-401, 30)"),
    link("position_limits_look_like_degrees_give_radians_or_position_limits_deg", "position_limits of a revolute joint",
         "not two whole numbers of which the larger is 90 to 400, 100, 200, 300 and 400 apart", f"{ONE}.position_limits(0, 360)",
         f"{ONE}.position_limits(-0.5, 360)"),
    link("alpha_is_beyond_one_turn_give_radians_or_alpha_deg", "alpha", "one turn", f"{ONE}.alpha(90)", f"{ONE}.alpha(6.28)"),
    link("alpha_is_beyond_one_turn_give_radians_or_alpha_deg", "alpha", "one turn", f"{ONE}.alpha_previous_deg(-360.1)",
         f"{ONE}.alpha_previous_deg(-360)"),
    link("alpha_is_beyond_one_turn_give_radians_or_alpha_deg", "alpha", "one turn", "classical_revolute().alpha(6.29)",
         "classical_revolute().alpha(6.28)"),
    link("theta_is_beyond_one_turn_give_radians_or_theta_deg", "theta", "one turn", f"{ONE}.theta(-6.29)", f"{ONE}.theta(-6.28)"),
    link("theta_is_beyond_one_turn_give_radians_or_theta_deg", "theta", "one turn", f"{ONE}.theta_deg(361)", f"{ONE}.theta_deg(360)"),
    link("gamma_of_branch_is_beyond_one_turn_give_radians_or_branch_deg", "branch", "gamma of one turn", f"{ONE}.branch(6.29, 0)",
         f"{ONE}.branch(6.28, 0)"),
    link("gamma_of_branch_is_beyond_one_turn_give_radians_or_branch_deg", "branch", "gamma of one turn", f"{ONE}.branch_deg(-361, 0)",
         f"{ONE}.branch_deg(-360, 0)"),
    link("inertia_without_mass_give_mass", "inertia", "with a mass", "revolute().inertia_com(0, 0, 1e-9)", "revolute().inertia_com(0, 0, 0)"),
    link("inertia_without_mass_give_mass", "inertia", "with a mass", "revolute().mass(0).inertia_com(1, 1, 1)",
         "revolute().mass(1e-9).inertia_com(1, 1, 1)"),
    link("com_without_mass_give_mass", "com", "with a mass, of 0 too", "revolute().com(0, 1e-9, 0)", "revolute().mass(0).com(0, 1e-9, 0)"),
    link("inertia_is_not_positive_definite_check_its_signs_and_order", "inertia", "least principal moment of -5 % of the largest",
         f"{ONE}.inertia_com(1, -0.051, 1)", f"{ONE}.inertia_com(1, -0.049, 1)"),
    link("inertia_is_not_positive_definite_check_its_signs_and_order", "inertia", "least principal moment of -5 % of the largest",
         f"{ONE}.inertia_com(0.4745, 0.4745, 1, 0.5255)", f"{ONE}.inertia_com(0.4755, 0.4755, 1, 0.5245)"),
    link("inertia_breaks_the_triangle_inequality_check_its_entries", "inertia",
         "largest principal moment of 105 % of the sum of the others (below 0: 0)", f"{ONE}.inertia_com(1, 1, 2.102)",
         f"{ONE}.inertia_com(1, 1, 2.098)"),
    link("inertia_breaks_the_triangle_inequality_check_its_entries", "inertia",
         "largest principal moment of 105 % of the sum of the others (below 0: 0)", f"{ONE}.inertia_com(1.551, 1.551, 1, 0.551)",
         f"{ONE}.inertia_com(1.549, 1.549, 1, 0.549)"),
    link("inertia_breaks_the_triangle_inequality_check_its_entries", "inertia",
         "largest principal moment of 105 % of the sum of the others (below 0: 0)", f"{ONE}.inertia_com(-0.01, 0.5, 0.526)",
         f"{ONE}.inertia_com(-0.01, 0.5, 0.524)"),
    robot("base_is_beyond_100_m_give_metres", "base()", "100 m", "base(100.1, 0, 0)", "base(99.9, 0, 0)"),
    robot("tool_is_beyond_100_m_give_metres", "tool()", "100 m", "tool(0, 0, -100.1)", "tool(0, 0, -99.9)"),
    robot("payload_limit_reach_is_beyond_100_m_give_metres", "payload_limit()", "reach of 100 m", "payload_limit(1, 100.1, 1)",
          "payload_limit(1, 99.9, 1)"),
]

# A quantity that is given twice, by one name or by two: .accept(axial::as_published) keeps the later one.
TWICE = [
    twice("a_is_given_twice_keep_one", ".a(1)", ".a_previous(1)"),
    twice("alpha_is_given_twice_keep_one", ".alpha(1)", ".alpha_deg(90)"),
    twice("d_is_given_twice_keep_one", ".d(1)"),
    twice("theta_is_given_twice_keep_one", ".theta(0)", ".theta_deg(0)"),
    twice("mass_is_given_twice_keep_one", ".mass(1)"),
    twice("com_is_given_twice_keep_one", ".com(0, 0, 0)"),
    twice("inertia_is_given_twice_keep_one", ".inertia_com(1, 1, 1)", ".inertia_origin(1, 1, 1)"),
    twice("rotor_inertia_is_given_twice_keep_one", ".rotor_inertia(1)", ".rotor_inertia(1, 2)"),
    twice("rotor_axis_is_given_twice_keep_one", ".rotor_axis(1, 0, 0)", ".rotor_axis(0, 1, 0)"),
    twice("viscous_is_given_twice_keep_one", ".viscous(1)"),
    twice("coulomb_is_given_twice_keep_one", ".coulomb(1)", ".coulomb(1, -1)"),
    twice("stribeck_is_given_twice_keep_one", ".stribeck(1, 1)"),
    twice("smooth_speed_is_given_twice_keep_one", ".smooth_speed(1)"),
    twice("spring_is_given_twice_keep_one", ".spring(1)", ".spring(1, 1)"),
    twice("stiffness_is_given_twice_keep_one", ".stiffness(1)"),
    twice("position_limits_are_given_twice_keep_one", ".position_limits(-1, 1)", ".position_limits_deg(-1, 1)"),
    twice("speed_limit_is_given_twice_keep_one", ".speed_limit(1)"),
    twice("acceleration_limit_is_given_twice_keep_one", ".acceleration_limit(1)"),
    twice("effort_limit_is_given_twice_keep_one", ".effort_limit(1)"),
    twice("parent_is_given_twice_keep_one", ".parent(0)", ".parent(LinkParameters::base)"),
    twice("branch_is_given_twice_keep_one", ".branch(1, 1)", ".branch_deg(1, 1)"),
    twice("added_mass_is_given_twice_keep_one", ".added_mass(1, 1, 1)"),
    twice("buoyancy_is_given_twice_keep_one", ".buoyancy(1, 0, 0, 0)"),
    twice("drag_linear_is_given_twice_keep_one", ".drag_linear(1, 1, 1)"),
    twice("drag_quadratic_is_given_twice_keep_one", ".drag_quadratic(1, 1, 1)"),
    part_twice("gravity_is_given_twice_keep_one", "gravity(0, 0, 0)"),
    part_twice("base_is_given_twice_keep_one", "base(0, 0, 0)"),
    part_twice("tool_is_given_twice_keep_one", "tool(0, 0, 0)"),
    part_twice("payload_limit_is_given_twice_keep_one", "payload_limit(1, 1, 1)"),
    part_twice("tip_wrench_limit_is_given_twice_keep_one", "tip_wrench_limit(1, 1)"),
    part_twice("base_body_is_given_twice_keep_one", "base_body().mass(1)"),
]

ALL = STRUCTURAL + DOUBTFUL + TWICE
