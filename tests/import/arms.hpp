// A small sound arm in each format: what broken ones and fuzzed ones are made of.
#pragma once

namespace arms {

constexpr const char* urdf = R"(<?xml version="1.0"?>
<robot name="arm">
  <link name="base"/>
  <link name="upper">
    <inertial><origin xyz="0.1 0.02 0" rpy="0.1 0.2 0.3"/><mass value="2.5"/>
      <inertia ixx="0.011" ixy="0.001" ixz="0" iyy="0.022" iyz="0" izz="0.023"/></inertial>
  </link>
  <link name="fore">
    <inertial><origin xyz="0.15 0 0.01" rpy="0 0 0"/><mass value="1.5"/>
      <inertia ixx="0.004" ixy="0" ixz="0" iyy="0.012" iyz="0" izz="0.013"/></inertial>
  </link>
  <link name="tool0">
    <inertial><origin xyz="0 0 0.05" rpy="0 0 1.5707963267948966"/><mass value="0.5"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.002"/></inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/><origin xyz="0 0 0.3" rpy="0 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-1.5" upper="1.25" effort="10" velocity="2"/><dynamics damping="0.3" friction="0.2"/>
  </joint>
  <joint name="elbow" type="prismatic">
    <parent link="upper"/><child link="fore"/><origin xyz="0.25 0 0.1" rpy="1.5707963267948966 0 0.4"/><axis xyz="0 1 1"/>
    <limit lower="0" upper="0.3" effort="20" velocity="1"/>
  </joint>
  <joint name="flange" type="fixed"><parent link="fore"/><child link="tool0"/><origin xyz="0.1 0 0" rpy="0 1.5708 0"/></joint>
</robot>
)";

constexpr const char* table = R"({"name": "arm", "source": "a test", "convention": "modified", "gravity": [0, 0, -9.81],
  "tool": {"xyz": [0, 0, 0.1], "rpy_deg": [0, 90, 0]},
  "links": [
    {"name": "upper", "type": "revolute", "d": 0.3, "mass": 2.5, "com": [0.1, 0, 0], "inertia_com": [0.01, 0.02, 0.02],
     "viscous": 0.3, "coulomb": [0.2, -0.1], "position_limits_deg": [-90, 80], "speed_limit": 2, "effort_limit": 10},
    {"name": "fore", "type": "prismatic", "parent": "upper", "a": 0.25, "alpha_deg": -90, "theta": 0.4, "mass": 1.5,
     "inertia_origin": [0.1, 0.2, 0.2, 0.01, 0, 0], "position_limits": [0, 0.3], "rotor_inertia": 1e-5, "gear": 50}
  ]}
)";

constexpr const char* mjcf = R"(<mujoco model="arm">
  <compiler angle="radian" autolimits="true"/>
  <option gravity="0 0 -9.81"/>
  <default><default class="link"><joint damping="0.3" armature="0.01"/><geom density="500"/></default></default>
  <worldbody>
    <body name="upper" pos="0 0 0.3" childclass="link">
      <joint name="shoulder" axis="0 0 1" range="-1.5 1.25" frictionloss="0.2"/>
      <inertial pos="0.1 0.02 0" mass="2.5" fullinertia="0.011 0.022 0.023 0.001 0 0"/>
      <frame pos="0.2 0 0" euler="0 0.1 0">
        <body name="fore" pos="0.05 0 0.1" quat="0.7 0.7 0.1 0">
          <joint name="elbow" type="slide" axis="0 1 1" range="0 0.3" stiffness="2" springref="0.1"/>
          <geom name="rod" type="capsule" fromto="0 0 0 0.2 0 0" size="0.02"/>
          <body name="hand" pos="0.2 0 0"><joint name="wrist" axis="1 0 0"/><geom size="0.03" mass="0.5"/>
            <site name="tool0" pos="0.05 0 0"/></body>
        </body>
      </frame>
    </body>
  </worldbody>
  <tendon><fixed name="pull"><joint joint="elbow" coef="1"/></fixed></tendon>
  <equality><joint name="law" joint1="wrist" joint2="shoulder" polycoef="0.1 0.5"/></equality>
  <actuator><motor name="m" joint="shoulder" ctrlrange="-1 1" gear="10"/><motor tendon="pull" forcerange="-20 20"/></actuator>
</mujoco>
)";

constexpr const char* sdf = R"(<?xml version="1.0"?>
<sdf version="1.9">
  <model name="arm">
    <pose>0 0 0.1 0 0 0.2</pose>
    <link name="base"/>
    <link name="upper">
      <pose relative_to="shoulder"/>
      <inertial><pose>0.1 0.02 0 0.1 0.2 0.3</pose><mass>2.5</mass>
        <inertia><ixx>0.011</ixx><ixy>0.001</ixy><ixz>0</ixz><iyy>0.022</iyy><iyz>0</iyz><izz>0.023</izz></inertia></inertial>
    </link>
    <link name="fore">
      <pose relative_to="upper">0.25 0 0.1 0.3 0 0.4</pose>
      <inertial><pose>0.15 0 0.01 0 0 0</pose><mass>1.5</mass>
        <inertia><ixx>0.004</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.012</iyy><iyz>0</iyz><izz>0.013</izz></inertia></inertial>
    </link>
    <link name="hand">
      <pose relative_to="tool">0 0 0.02 0 0 0</pose>
      <inertial><mass>0.5</mass>
        <inertia><ixx>0.001</ixx><ixy>0</ixy><ixz>0</ixz><iyy>0.002</iyy><iyz>0</iyz><izz>0.002</izz></inertia></inertial>
    </link>
    <frame name="tool" attached_to="fore"><pose>0.1 0 0 0 1.5 0</pose></frame>
    <joint name="stand" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="shoulder" type="revolute">
      <pose relative_to="base">0 0 0.3 0 0 0</pose><parent>base</parent><child>upper</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-1.5</lower><upper>1.25</upper><effort>10</effort><velocity>2</velocity></limit>
        <dynamics><damping>0.3</damping><friction>0.2</friction></dynamics></axis>
    </joint>
    <joint name="elbow" type="prismatic">
      <parent>upper</parent><child>fore</child>
      <axis><xyz expressed_in="upper">0 1 1</xyz><limit><lower>0</lower><upper>0.3</upper></limit>
        <dynamics><spring_stiffness>2</spring_stiffness><spring_reference>0.1</spring_reference></dynamics></axis>
    </joint>
    <joint name="wrist" type="continuous">
      <parent>fore</parent><child>hand</child>
      <axis><xyz>1 0 0</xyz><mimic joint="shoulder"><multiplier>0.5</multiplier><offset>0.1</offset></mimic></axis>
    </joint>
  </model>
</sdf>
)";

}  // namespace arms
