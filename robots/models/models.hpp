// Robots for counting operations: the geometry of a kind of arm, every other constant generic (no value is 0 or +-1,
// none stands twice), so that a count shows what the structure costs and not what one arm's values happen to save.
//
// published: which of alpha, a, d are zero, as in the symbolic generators' examples of these arms; MDH.
// assumed:   every value, chosen only to be a plausible body and to coincide with nothing. No arm is described here.
#pragma once

#include <robots/robots.hpp>

namespace robots {

/// Body of link i: all ten inertial parameters generic, positive definite, smaller towards the tip.
struct ModelBody {
  static constexpr axial::Link give(const axial::Link& link, int i) {
    const double k = 1.0 - 0.083 * i, s = k * k, m = 6.13 * s;
    return link.mass(m)
        .com(0.037 * k, -0.053 * k, 0.091 * k)
        .inertia_com(0.0131 * m * s, 0.0119 * m * s, 0.0083 * m * s, 0.00071 * m * s, -0.00057 * m * s, 0.00089 * m * s)
        .position_limits(-3.0, 3.0)
        .speed_limit(2.0)
        .acceleration_limit(8.0);
  }
};

/// What stands between two joints; alpha in degrees.
struct ModelRow {
  double alpha_deg = 0.0, a = 0.0, d = 0.0;
  bool prismatic = false;
};

template <int N>
constexpr axial::Chain<N> model_chain(const ModelRow (&rows)[N]) {
  axial::Chain<N> chain;  // gravity along -z
  for (int i = 0; i < N; ++i) {
    const auto joint = rows[i].prismatic ? axial::prismatic() : axial::revolute();
    chain.links[i] = ModelBody::give(joint, i).alpha_deg(rows[i].alpha_deg).a(rows[i].a).d(rows[i].d).parameters();
  }
  return chain;
}

struct ModelPuma560 {
  static constexpr const char* name = "model_puma560";
  static constexpr auto chain =
      model_chain<6>({{0.0}, {-90.0}, {0.0, 0.43, 0.17}, {-90.0, 0.021, 0.47}, {90.0}, {-90.0}});
};

struct ModelRx90 {
  static constexpr const char* name = "model_rx90";
  static constexpr auto chain = model_chain<6>({{0.0}, {90.0}, {0.0, 0.46}, {-90.0, 0.0, 0.44}, {90.0}, {-90.0}});
};

struct ModelUr5 {
  static constexpr const char* name = "model_ur5";
  static constexpr auto chain =
      model_chain<6>({{0.0}, {90.0}, {0.0, 0.42}, {0.0, 0.39, 0.11}, {90.0, 0.0, 0.093}, {-90.0, 0.0, 0.081}});
};

struct ModelIiwa {
  static constexpr const char* name = "model_iiwa";
  static constexpr auto chain =
      model_chain<7>({{0.0}, {-90.0}, {90.0, 0.0, 0.42}, {90.0}, {-90.0, 0.0, 0.39}, {-90.0}, {90.0}});
};

/// No right angle anywhere, and no zero but those of the first row, which only say where frame 0 stands.
struct ModelGeneral6r {
  static constexpr const char* name = "model_general6r";
  static constexpr auto chain = model_chain<6>(
      {{0.0}, {-71.0, 0.19, 0.23}, {34.0, 0.41, 0.13}, {-58.0, 0.27, 0.36}, {77.0, 0.11, 0.15}, {-43.0, 0.071, 0.062}});
};

struct ModelScaraRrp {
  static constexpr const char* name = "model_scara_rrp";
  static constexpr auto chain = model_chain<3>({{0.0}, {0.0, 0.37}, {0.0, 0.31, 0.0, true}});
};

struct ModelScaraRrpr {
  static constexpr const char* name = "model_scara_rrpr";
  static constexpr auto chain = model_chain<4>({{0.0}, {0.0, 0.37}, {0.0, 0.31, 0.0, true}, {0.0}});
};

using Models = List<ModelPuma560, ModelRx90, ModelUr5, ModelIiwa, ModelGeneral6r, ModelScaraRrp, ModelScaraRrpr>;

namespace detail {
template <class... A, class... B>
List<A..., B...> joined(List<A...>, List<B...>);
}
using AllAndModels = decltype(detail::joined(All{}, Models{}));

}  // namespace robots
