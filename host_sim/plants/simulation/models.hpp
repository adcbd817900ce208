// Robots as a plant integrates them: run-time models, one type for all, so that a method is compiled once.
#pragma once

#include <axial/axial.hpp>
#include <axial/simulation/energy.hpp>
#include <axial/simulation/step_limit.hpp>

#include <string>
#include <vector>

namespace host_sim::simulation {

/// Everything that a plant can have: gravity, rotors, friction, springs, a force at the tip.
using Model =
    axial::Model<12, axial::Gravity, axial::RotorInertia, axial::Friction, axial::JointSprings, axial::TipWrench>;
template <class T>
using Values = axial::Joints<Model, T>;
/// The same of robots whose joints share drives: values, efforts and motions are those of the drives.
using DrivenModel = axial::Model<12, axial::Gravity, axial::RotorInertia, axial::Friction, axial::JointSprings,
                                 axial::TipWrench, axial::SharedDrives>;

/// A robot of robots/ as it is declared. Throws std::runtime_error that names the robots there are, also where joints
/// share drives.
Model robot_model(const std::string& robot);
/// Its links, for plants that are not quite what the firmware believes; also where joints share drives.
std::vector<axial::LinkParameters> robot_links(const std::string& robot);
/// A model of such links, standing as the robot does.
Model model_of(const std::string& robot, const std::vector<axial::LinkParameters>& links);
std::vector<std::string> robot_names();

/// A link with a body fixed to it, in the link's frame.
axial::LinkParameters carrying(axial::LinkParameters link, const axial::PayloadBody<double>& load);

/// Robots whose joints share drives.
///@{
DrivenModel driven_model(const std::string& robot);
DrivenModel driven_model_of(const std::string& robot, const std::vector<axial::LinkParameters>& links);
std::vector<std::string> driven_robot_names();
/// Whether a robot is one of them.
bool shares_drives(const std::string& robot);
///@}
/// What a robot's values belong to: its links, or its drives by themselves where joints share them. A drive is
/// prismatic that alone moves a slide, whose unit it then has, else revolute.
std::vector<axial::LinkParameters> robot_values(const std::string& robot);

/// IFToMM benchmark A01: a point mass of 1 kg on a rod of 1 m, horizontal at q = 0, g = 9.81 m/s^2.
Model pendulum();
/// n <= 12 uniform rods of 1 m and 1 kg, planar, horizontal at q = 0; as slim as stability scenario S01 has them, or
/// with no inertia about their axis.
Model rods(int n);
/// Kane's babyboot with the figures of MotionGenesis: a rod of 7.5 cm that swings, and a plate 20 cm below that turns
/// about the rod.
Model babyboot();
/// The nominal arm of the stability scenarios with springs of stiffness K (N m/rad) about `rest`, and dampers (N m
/// s/rad).
Model sprung_arm(double stiffness, const Values<double>& rest, double damping = 0.0);
/// A leg on a vertical slide: hip and knee.
Model leg();

/// The pose that the scenarios of the nominal arm start from.
Values<double> nominal_pose();

/// Kinetic and potential energy, J: of links, rotors and springs.
///@{
double energy(const Model& model, const Values<double>& q, const Values<double>& qd);
double energy(const DrivenModel& model, const axial::Joints<DrivenModel, double>& u,
              const axial::Joints<DrivenModel, double>& ud);
///@}

}  // namespace host_sim::simulation
