// The machines of this folder, as a list of types; gallery.py writes it from gallery.json.
#pragma once

#include <robots/gallery/arms/baxter_arm.hpp>
#include <robots/gallery/arms/cr5.hpp>
#include <robots/gallery/arms/fr3.hpp>
#include <robots/gallery/arms/gen3.hpp>
#include <robots/gallery/arms/gen3_6.hpp>
#include <robots/gallery/arms/gen3_lite.hpp>
#include <robots/gallery/arms/iiwa14.hpp>
#include <robots/gallery/arms/iiwa7.hpp>
#include <robots/gallery/arms/lite6.hpp>
#include <robots/gallery/arms/m1013.hpp>
#include <robots/gallery/arms/rizon4.hpp>
#include <robots/gallery/arms/sawyer.hpp>
#include <robots/gallery/arms/ur10e.hpp>
#include <robots/gallery/arms/ur3e.hpp>
#include <robots/gallery/arms/ur5e.hpp>
#include <robots/gallery/arms/xarm6.hpp>
#include <robots/gallery/arms/xarm7.hpp>
#include <robots/gallery/desk/arx_l5.hpp>
#include <robots/gallery/desk/koch.hpp>
#include <robots/gallery/desk/openarm.hpp>
#include <robots/gallery/desk/openmanipulator_x.hpp>
#include <robots/gallery/desk/piper.hpp>
#include <robots/gallery/desk/so100.hpp>
#include <robots/gallery/desk/so101.hpp>
#include <robots/gallery/desk/vx300s.hpp>
#include <robots/gallery/desk/wx250s.hpp>
#include <robots/gallery/desk/yam.hpp>
#include <robots/gallery/desk/z1.hpp>
#include <robots/gallery/hands/allegro_finger.hpp>
#include <robots/gallery/hands/dex3_thumb.hpp>
#include <robots/gallery/hands/leap_finger.hpp>
#include <robots/gallery/hands/robotiq_2f85.hpp>
#include <robots/gallery/mobile/a1_leg.hpp>
#include <robots/gallery/mobile/anymal_c_leg.hpp>
#include <robots/gallery/mobile/go1_leg.hpp>
#include <robots/gallery/mobile/go2_leg.hpp>
#include <robots/gallery/mobile/solo12_leg.hpp>
#include <robots/gallery/mobile/spot_arm.hpp>
#include <robots/gallery/mobile/stretch_arm.hpp>
#include <robots/gallery/scaras/m1_pro.hpp>
#include <robots/gallery/scaras/mg400.hpp>
#include <robots/gallery/scaras/z_arm.hpp>
#include <robots/robots.hpp>

namespace robots {

/// Real machines, each made by `./axial import` from a public description.
using Gallery = List<So100, So101, OpenmanipulatorX, Vx300s, Xarm7, Ur5e, Ur10e, Gen3, Iiwa14, Z1, Sawyer, Go2Leg,
                     A1Leg, AnymalCLeg, Openarm, Lite6, Koch, Wx250s, Piper, ArxL5, Yam, Xarm6, Ur3e, Fr3, Gen36,
                     Gen3Lite, Iiwa7, M1013, Cr5, Rizon4, BaxterArm, StretchArm, SpotArm, Go1Leg, Solo12Leg,
                     AllegroFinger, LeapFinger, Dex3Thumb, Robotiq2f85, M1Pro, ZArm, Mg400>;

}  // namespace robots
