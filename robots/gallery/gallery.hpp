// The machines of this folder, as a list of types; gallery.py writes it from gallery.json.
#pragma once

#include <robots/gallery/arms/gen3.hpp>
#include <robots/gallery/arms/iiwa14.hpp>
#include <robots/gallery/arms/lite6.hpp>
#include <robots/gallery/arms/sawyer.hpp>
#include <robots/gallery/arms/ur10e.hpp>
#include <robots/gallery/arms/ur5e.hpp>
#include <robots/gallery/arms/xarm7.hpp>
#include <robots/gallery/desk/openarm.hpp>
#include <robots/gallery/desk/openmanipulator_x.hpp>
#include <robots/gallery/desk/so100.hpp>
#include <robots/gallery/desk/so101.hpp>
#include <robots/gallery/desk/vx300s.hpp>
#include <robots/gallery/desk/z1.hpp>
#include <robots/gallery/mobile/a1_leg.hpp>
#include <robots/gallery/mobile/anymal_c_leg.hpp>
#include <robots/gallery/mobile/go2_leg.hpp>
#include <robots/robots.hpp>

namespace robots {

/// Real machines, each made by `./axial import` from a public description.
using Gallery = List<So100, So101, OpenmanipulatorX, Vx300s, Xarm7, Ur5e, Ur10e, Gen3, Iiwa14, Z1, Sawyer, Go2Leg,
                     A1Leg, AnymalCLeg, Openarm, Lite6>;

}  // namespace robots
