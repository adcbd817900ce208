// The machines of this folder, as a list of types.
#pragma once

#include <robots/gallery/a1_leg.hpp>
#include <robots/gallery/anymal_c_leg.hpp>
#include <robots/gallery/gen3.hpp>
#include <robots/gallery/go2_leg.hpp>
#include <robots/gallery/iiwa14.hpp>
#include <robots/gallery/lite6.hpp>
#include <robots/gallery/openarm.hpp>
#include <robots/gallery/openmanipulator_x.hpp>
#include <robots/gallery/sawyer.hpp>
#include <robots/gallery/so100.hpp>
#include <robots/gallery/so101.hpp>
#include <robots/gallery/ur10e.hpp>
#include <robots/gallery/ur5e.hpp>
#include <robots/gallery/vx300s.hpp>
#include <robots/gallery/xarm7.hpp>
#include <robots/gallery/z1.hpp>
#include <robots/robots.hpp>

namespace robots {

/// Real machines, each made by `./axial import` from a public description.
using Gallery = List<So100, So101, OpenmanipulatorX, Vx300s, Xarm7, Ur5e, Ur10e, Gen3, Iiwa14, Z1, Sawyer, Go2Leg,
                     A1Leg, AnymalCLeg, Openarm, Lite6>;

}  // namespace robots
