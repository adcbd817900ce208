// Large robots, to see what their kernels cost a compiler: a humanoid and arms of any number of joints.
//
// assumed: everything. The humanoid's numbers are drawn, of the size usual at 1.3 m, and as an import of a URDF writes
//          them: many digits, offsets along all axes, angles that are no multiples of 90 degrees where limbs begin.
#pragma once

#include <axial/robot/chain.hpp>

namespace robots {

/// A waist of three joints with two arms of seven, and two legs of six beside it on the base: a tree of 29 joints.
struct Humanoid {
  static constexpr const char* name = "humanoid";

  // A line a group of values.
  // clang-format off
  static constexpr auto chain = axial::chain(
      axial::gravity(0.0, 0.0, -9.81),
      // 0: waist, yaw
      axial::revolute().a(0.000962381076234).alpha_deg(0).d(0.0369166364667611).theta_deg(90)
          .mass(0.267243).com(-0.001690121, 0.009477176, -0.007925346)
          .inertia_com(0.000207815177, 0.000242179938, 0.000216126527, -0.000001838639, -0.000009150266, -0.000005001976)
          .position_limits(-2.6, 2.6).speed_limit(32.0).acceleration_limit(128.0).effort_limit(88.0),
      // 1: waist, roll
      axial::revolute().a(0.0099748022106126).alpha_deg(90).d(-0.003414020699642).theta_deg(90)
          .mass(0.061293).com(-0.005273027, -0.001057397, -0.001471038)
          .inertia_com(0.000033438358, 0.000040937398, 0.000034073335, 0.000001566079, 0.000000334953, -0.000001624295)
          .position_limits(-0.52, 0.52).speed_limit(30.0).acceleration_limit(120.0).effort_limit(35.0),
      // 2: waist, pitch; the trunk
      axial::revolute().a(0.0167384521232866).alpha_deg(90).d(-0.1209747510629512).theta(-1.5697621837630142)
          .mass(8.873330).com(0.022709059, 0.023106559, 0.007838412)
          .inertia_com(0.152237906427, 0.194033480219, 0.163413911023, 0.0035358249, -0.002501896046, 0.002873082739)
          .position_limits(-0.52, 0.52).speed_limit(30.0).acceleration_limit(120.0).effort_limit(35.0),
      // 3: left shoulder, pitch
      axial::revolute().a(0.0087525977029878).alpha(-0.2816381279910135).d(0.8208667761803611).theta(1.563000004394139)
          .mass(0.697057).com(0.003728316, -0.000801893, 0.010446862)
          .inertia_com(0.000662596448, 0.000842918942, 0.000852971477, 0.000016896197, -0.000018974592, 0.000039744789)
          .position_limits(-3.0, 2.6).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 4: left shoulder, roll
      axial::revolute().a(0.0079620021502112).alpha_deg(-90).d(0.0093463561885098).theta(1.2734343489489148)
          .mass(0.699600).com(-0.011474964, 0.010170134, 0.009849589)
          .inertia_com(0.00073725344, 0.000777658939, 0.001214642593, -0.000042949372, -0.000041194842, 0.000049065605)
          .position_limits(-1.6, 2.2).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 5: left shoulder, yaw
      axial::revolute().a(0.0091942396569108).alpha_deg(90).d(-0.1813034584337235).theta_deg(-90)
          .mass(0.762778).com(0.003836501, 0.011466677, 0.013468314)
          .inertia_com(0.001823719623, 0.001353097646, 0.001079013147, 0.000002557917, -0.000084877572, -0.000056219371)
          .position_limits(-2.6, 2.6).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 6: left elbow
      axial::revolute().a(-0.0020358907074943).alpha_deg(90).d(-0.0026939419607977).theta_deg(-90)
          .mass(0.543322).com(-0.010068187, -0.008698065, -0.012124147)
          .inertia_com(0.000665759816, 0.000826323153, 0.000633610162, 0.000028742896, 0.000037066245, -0.000030234654)
          .position_limits(-1.0, 2.0).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 7: left wrist, roll
      axial::revolute().a(0.016339902420963).alpha_deg(90).d(0.1387626209506601).theta_deg(0)
          .mass(0.199232).com(0.002180983, 0.005290364, 0.001313873)
          .inertia_com(0.000129558288, 0.000184518645, 0.000171705477, -0.000003838007, 0.000003839453, 0.000005885351)
          .position_limits(-1.9, 1.9).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 8: left wrist, pitch
      axial::revolute().a(-0.0044452388664365).alpha_deg(-90).d(-0.0017790624192311).theta_deg(-90)
          .mass(0.460255).com(-0.001302796, -0.002433827, -0.000000747)
          .inertia_com(0.000527803538, 0.000357783339, 0.000463581734, 0.00002261076, 0.000009054339, -0.000006332471)
          .position_limits(-1.6, 1.6).speed_limit(22.0).acceleration_limit(88.0).effort_limit(5.0),
      // 9: left wrist, yaw
      axial::revolute().a(0.0415041756756875).alpha_deg(90).d(-0.0015557872786412).theta(-0.0011654599297674)
          .mass(0.257302).com(0.008215161, -0.001141240, -0.005556834)
          .inertia_com(0.000314932833, 0.000205329259, 0.000304498937, -0.00000873696, 0.000013840528, -0.000010721494)
          .position_limits(-1.6, 1.6).speed_limit(22.0).acceleration_limit(88.0).effort_limit(5.0),
      // 10: right shoulder, pitch
      axial::revolute().parent(2).branch(0.0110895365164493, 1.319836735324653).a(0.0029654375482459).alpha(0.282619343824617).d(-0.9249165823580061).theta(1.5606271409917694)
          .mass(0.739908).com(-0.000871355, -0.004510828, -0.009451366)
          .inertia_com(0.000694417615, 0.000990330993, 0.00128397524, -0.000022010461, -0.000019971181, -0.000042542348)
          .position_limits(-3.0, 2.6).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 11: right shoulder, roll
      axial::revolute().a(0.0080999657080754).alpha_deg(-90).d(0.0020469732827871).theta(-1.2282139903292997)
          .mass(0.589714).com(-0.003124108, 0.007630318, -0.006507767)
          .inertia_com(0.000642403615, 0.00099619038, 0.000534491251, -0.000023939088, 0.000011752993, -0.000021228845)
          .position_limits(-1.6, 2.2).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 12: right shoulder, yaw
      axial::revolute().a(-0.0032785090327835).alpha_deg(-90).d(-0.1860838602139358).theta_deg(90)
          .mass(0.700610).com(0.014412521, -0.012815945, -0.007299746)
          .inertia_com(0.001573177453, 0.001649312991, 0.001676437246, 0.000122457476, 0.000075017428, 0.000065553508)
          .position_limits(-2.6, 2.6).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 13: right elbow
      axial::revolute().a(-0.0111076121913658).alpha_deg(90).d(-0.0037166455357675).theta_deg(-90)
          .mass(0.573040).com(0.004125338, 0.006116270, -0.005548125)
          .inertia_com(0.001114820291, 0.001023219647, 0.000796004027, -0.000050129463, 0.000039624426, 0.000026473918)
          .position_limits(-1.0, 2.0).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 14: right wrist, roll
      axial::revolute().a(0.0180717572372298).alpha_deg(90).d(0.1374274424032679).theta_deg(0)
          .mass(0.204348).com(-0.006769943, 0.003538483, -0.002764481)
          .inertia_com(0.00016470172, 0.000136036711, 0.000191741842, 0.000008915788, 0.000006613516, -0.000007074842)
          .position_limits(-1.9, 1.9).speed_limit(37.0).acceleration_limit(148.0).effort_limit(25.0),
      // 15: right wrist, pitch
      axial::revolute().a(-0.004843679931647).alpha_deg(-90).d(-0.0026623924585737).theta_deg(-90)
          .mass(0.524283).com(-0.005754848, -0.001096513, 0.000654148)
          .inertia_com(0.000560047287, 0.000538896308, 0.000384859961, 0.000007162389, -0.000027100291, 0.000021137914)
          .position_limits(-1.6, 1.6).speed_limit(22.0).acceleration_limit(88.0).effort_limit(5.0),
      // 16: right wrist, yaw
      axial::revolute().a(0.0424464588205503).alpha_deg(90).d(0.0021417875853682).theta(-0.0073075298943062)
          .mass(0.239823).com(0.007504273, 0.006560870, 0.004368901)
          .inertia_com(0.000272485231, 0.000177028177, 0.000216397257, -0.000007280618, 0.000003606715, -0.000000752477)
          .position_limits(-1.6, 1.6).speed_limit(22.0).acceleration_limit(88.0).effort_limit(5.0),
      // 17: left hip, pitch
      axial::revolute().parent(axial::LinkParameters::base).branch(-0.0078148964058369, -0.102279531878063).a(0.0034970642785004).alpha_deg(-90).d(0.1189374005656441).theta(1.3884954522202875)
          .mass(1.253842).com(0.004000654, -0.002885104, 0.002198921)
          .inertia_com(0.001887036211, 0.002579750219, 0.002520637819, -0.000130223372, -0.000123593291, 0.000092272847)
          .position_limits(-2.5, 2.8).speed_limit(32.0).acceleration_limit(128.0).effort_limit(88.0),
      // 18: left hip, roll
      axial::revolute().a(0.0211124256218444).alpha_deg(90).d(0.00491700082451).theta_deg(-90)
          .mass(1.458944).com(-0.005497617, -0.010453478, -0.001170890)
          .inertia_com(0.002343016652, 0.003541443025, 0.003758270205, -0.000145199945, 0.000172546321, -0.000178551686)
          .position_limits(-0.5, 2.9).speed_limit(32.0).acceleration_limit(128.0).effort_limit(88.0),
      // 19: left hip, yaw
      axial::revolute().a(0.000183977246798).alpha_deg(90).d(-0.3083693010052997).theta_deg(-90)
          .mass(1.530800).com(0.013486534, 0.014340557, 0.005447147)
          .inertia_com(0.011699103845, 0.009675896165, 0.009833805487, 0.000253774602, -0.000285329914, -0.000614497983)
          .position_limits(-2.7, 2.7).speed_limit(32.0).acceleration_limit(128.0).effort_limit(88.0),
      // 20: left knee
      axial::revolute().a(0.0772624690272097).alpha_deg(90).d(0.0023506658728468).theta(-1.385238727626731)
          .mass(1.986681).com(0.020753097, -0.027499261, -0.013195333)
          .inertia_com(0.010403469849, 0.015424473594, 0.010415160506, 0.000055998726, 0.000614524497, 0.000262044818)
          .position_limits(-0.1, 2.8).speed_limit(20.0).acceleration_limit(80.0).effort_limit(139.0),
      // 21: left ankle, pitch
      axial::revolute().a(0.2926154809372715).alpha_deg(0).d(0.0013498619050392).theta_deg(0)
          .mass(0.084740).com(-0.003492447, -0.002127156, -0.002630753)
          .inertia_com(0.000024525627, 0.000024954501, 0.000033188597, -0.000001013582, -0.000001116401, -0.000000454996)
          .position_limits(-0.87, 0.52).speed_limit(30.0).acceleration_limit(120.0).effort_limit(35.0),
      // 22: left ankle, roll
      axial::revolute().a(0.0117913592876553).alpha_deg(90).d(-0.0014492637587729).theta_deg(0)
          .mass(0.563585).com(-0.001701781, 0.003227963, 0.015283310)
          .inertia_com(0.00136965225, 0.001474670469, 0.001080648918, 0.000080603084, -0.000067121601, 0.000076932159)
          .position_limits(-0.26, 0.26).speed_limit(30.0).acceleration_limit(120.0).effort_limit(35.0),
      // 23: right hip, pitch
      axial::revolute().parent(axial::LinkParameters::base).branch(0.0122522678865759, -0.10775036125492).a(-0.006028791431255).alpha_deg(-90).d(-0.1149843052331108).theta(1.3856806576285057)
          .mass(1.299235).com(-0.013003432, -0.002109821, -0.007765802)
          .inertia_com(0.002152806314, 0.002355887825, 0.002354979718, 0.00014321801, -0.000122807182, -0.000126971215)
          .position_limits(-2.5, 2.8).speed_limit(32.0).acceleration_limit(128.0).effort_limit(88.0),
      // 24: right hip, roll
      axial::revolute().a(0.0235415751813463).alpha_deg(90).d(-0.0100098462045765).theta_deg(-90)
          .mass(1.618580).com(0.007182897, -0.007257550, 0.000472524)
          .inertia_com(0.002348327226, 0.004283911031, 0.003514891622, -0.000105328277, 0.000097920294, 0.000015483333)
          .position_limits(-0.5, 2.9).speed_limit(32.0).acceleration_limit(128.0).effort_limit(88.0),
      // 25: right hip, yaw
      axial::revolute().a(-0.0048221324572489).alpha_deg(90).d(-0.306888121124507).theta_deg(-90)
          .mass(1.535692).com(0.020048952, -0.008360518, -0.007646144)
          .inertia_com(0.006420700218, 0.009166060432, 0.011754014428, 0.000153065845, -0.000012807573, 0.000299738509)
          .position_limits(-2.7, 2.7).speed_limit(32.0).acceleration_limit(128.0).effort_limit(88.0),
      // 26: right knee
      axial::revolute().a(0.072006370287602).alpha_deg(90).d(-0.0011788039532397).theta(-1.3811727558039724)
          .mass(1.847679).com(0.018627918, 0.026412329, 0.003846194)
          .inertia_com(0.01470523163, 0.012580720034, 0.013009253997, 0.000990221556, -0.000465568029, -0.00035477672)
          .position_limits(-0.1, 2.8).speed_limit(20.0).acceleration_limit(80.0).effort_limit(139.0),
      // 27: right ankle, pitch
      axial::revolute().a(0.2969727355365182).alpha_deg(0).d(-0.0009608363059418).theta_deg(0)
          .mass(0.098769).com(0.001340181, -0.000151925, 0.004192041)
          .inertia_com(0.000025018997, 0.000039942132, 0.000036767705, -0.000001895567, 0.00000172758, -0.000000528024)
          .position_limits(-0.87, 0.52).speed_limit(30.0).acceleration_limit(120.0).effort_limit(35.0),
      // 28: right ankle, roll
      axial::revolute().a(0.0123619042358846).alpha_deg(90).d(-0.0029997836164913).theta_deg(0)
          .mass(0.645690).com(0.015267063, 0.003593243, 0.015560520)
          .inertia_com(0.001055711709, 0.0018327936, 0.001231436617, -0.000076283541, -0.000026914204, 0.000084282323)
          .position_limits(-0.26, 0.26).speed_limit(30.0).acceleration_limit(120.0).effort_limit(35.0));
  // clang-format on
};

/// `Limbs` arms of `Joints` joints each, side by side on the base, every one with a twist of its own. Links are short
/// and sturdy where `sturdy`, so that elimination loses little.
template <int Limbs, int Joints, bool sturdy = false>
struct Limbed {
  static constexpr axial::Link link(int i) {
    const int k = i % Joints, limb = i / Joints;
    const double size = 1.0 - 0.004 * i, arm = sturdy ? 0.031234567 : 0.212345678;
    const double j = sturdy ? 0.3123456 : 0.0123456;
    const auto at = axial::revolute()
                        .a(k == 0 ? 0.0 : arm * size)
                        .alpha(k == 0       ? 0.0
                               : k % 2 == 1 ? 1.5707963
                                            : -1.3712345)
                        .d(0.0512345 * (k % 3))
                        .theta(0.1234567 * k)
                        .mass(2.1234567 * size)
                        .com(0.0123456 * size, 0.0234567, 0.0171234)
                        .inertia_com(j * size, 1.03 * j * size, 1.05 * j, 0.01 * j, 0.02 * j, 0.003 * j);
    return k > 0 || i == 0 ? at : at.parent(axial::LinkParameters::base).branch(0.2123456 * limb, 0.1123456 * limb);
  }
  template <int... I>
  static constexpr auto links(std::integer_sequence<int, I...>) {
    return axial::chain(axial::gravity(0.0, 0.0, -9.81), link(I)...);
  }
  static constexpr auto chain = links(std::make_integer_sequence<int, Limbs * Joints>{});
};
/// A serial chain.
template <int Joints>
using Serial = Limbed<1, Joints>;

}  // namespace robots
