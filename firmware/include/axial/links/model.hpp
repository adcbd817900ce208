// A robot that is described at run time: for tests, reports, import and plants on the host.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/links/links.hpp>
#include <axial/links/rotors.hpp>
#include <axial/links/run_time_model.hpp>
#include <axial/links/water_constants.hpp>
#include <axial/robot/base_body.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// The links of a run-time model: a table, and the body that is fixed to frame 0.
template <class SceneType, class ScalarType, int N>
class ModelLinks : public TableLinks<SceneType, ScalarType, double, N> {
  using Table = TableLinks<SceneType, ScalarType, double, N>;

 public:
  /// `waters`: of the links, and of the base body last.
  AXIAL_INLINE constexpr ModelLinks(const Table& table, const TreeLinkConstants<double>& base,
                                    const WaterConstants<double>* waters, const RotorConstants<double>* rotors)
      : Table(table), base_(base), waters_(waters), rotors_(rotors) {}

  /// The base body as a link without a joint.
  AXIAL_INLINE constexpr auto base_link() const {
    return TableLink<SceneType, ScalarType, double, typename Table::SharedColumns>(base_, nullptr, false);
  }
  AXIAL_INLINE constexpr const WaterConstants<double>& water(int i) const { return waters_[i]; }  ///< about link i
  AXIAL_INLINE constexpr const RotorConstants<double>& rotor(int i) const { return rotors_[i]; }  ///< of joint i
  /// The water about the base body.
  AXIAL_INLINE constexpr const WaterConstants<double>& base_water() const { return waters_[N]; }

 private:
  const TreeLinkConstants<double>& base_;
  const WaterConstants<double>* waters_;
  const RotorConstants<double>* rotors_;
};

namespace detail {
/// What a Model keeps of joints that share drives: nothing, unless its features name SharedDrives (driven_model.hpp).
template <class Model, int N, bool shared>
struct ModelDrives {
  constexpr bool take(const LinkParameters& link, int) { return link.drives.count == 0; }
  template <class T>
  constexpr auto links(const Model& model) const {
    return model.template joint_links<typename Model::Scene, T>();
  }
  constexpr int size(int joints) const { return joints; }
  constexpr bool sound(int) const { return true; }
};
}  // namespace detail

/// Up to N links, filled at run time; the algorithms run over it in their looped form. Stands where a robot or scene
/// stands: `inverse_dynamics(model, q, qd, qdd)` with `Joints<Model<N>, T>`. Features as for Scene; without any,
/// gravity and rotor inertia. No allocation; add() says false where a link is refused (full, or its parent is not
/// before it, or it has a branch and the features name Unbranched, or its rotor's carrier is not inboard of it, or it
/// names drives and the features do not name SharedDrives).
template <int N, class... Features>
class Model {
 public:
  using Robot = Model;  ///< where a robot's type stands
  /// What is known of its chain at compile time.
  struct Size {
    int size = N;  ///< number of links, at most
  };
  static constexpr Size chain{};  ///< stands where a robot's chain stands
  /// the model with its features
  using Scene = std::conditional_t<sizeof...(Features) == 0, axial::Scene<Model, Gravity, RotorInertia>,
                                   axial::Scene<Model, Features...>>;

  /// Adds a link whose parent is before it; false where it is refused.
  [[nodiscard]] constexpr bool add(const LinkParameters& link) {
    const int parent = link.parent == LinkParameters::previous ? size_ - 1 : link.parent;
    if (Scene::template has<Unbranched> && link_constants(link, parent).branches()) return false;
    if (size_ >= N || parent >= size_ || parent < LinkParameters::base) return false;
    if (!carries(link, parent) || !shared_.take(link, size_)) return false;
    waters_[size_] = water_constants(link.water);
    rotors_[size_] = rotor_constants(link, parent);
    drives_[size_] = drive_constants(link);
    table_[size_++] = link_constants(link, parent);
    return true;
  }
  [[nodiscard]] constexpr bool add(const Link& link) {
    return add(link.parameters());
  }  ///< as revolute() or prismatic() describe it
  /// Acceleration of free fall in frame 0, m/s^2.
  constexpr void set_gravity(double x, double y, double z) { placement_.gravity = {x, y, z}; }
  /// Pose of frame 0 in the world, and of the tool in the last link's frame: only kinematics sees them.
  constexpr void set_base(const FixedPose& pose) { placement_.base = pose; }
  /// pose of the tool in the last link's frame
  constexpr void set_tool(const FixedPose& pose) { placement_.tool = pose; }
  /// The body that is fixed to frame 0, for the feature FloatingBase.
  constexpr void set_base_body(const LinkParameters& body) {
    base_body_ = link_constants(body, LinkParameters::base);
    waters_[N] = water_constants(body.water);
  }
  /// Sets the base body as base_body() describes it.
  constexpr void set_base_body(const BaseBody& body) { set_base_body(body.parameters()); }
  constexpr int size() const { return shared_.size(size_); }  ///< number of joint values: links, or drives that share
  constexpr int link_count() const { return size_; }          ///< number of links added so far
  /// Whether all drives that joints name are there, each with a motion of its own, and every joint is moved.
  [[nodiscard]] constexpr bool drives_are_sound() const { return shared_.sound(size_); }
  constexpr const TreeLinkConstants<double>& constants(int i) const { return table_[i]; }  ///< of link i

  /// The links over numbers T, as algorithms walk over them; they refer to the model.
  template <class T>
  constexpr auto links() const {
    if constexpr (detail::is_word<T>)
      return RefusedLinks<Scene>{};  // Inputs say it
    else
      return shared_.template links<T>(*this);
  }

 private:
  template <class, int, bool>
  friend struct detail::ModelDrives;
  /// The tree alone, of features that a scene names.
  template <class SceneType, class T>
  constexpr auto joint_links() const {
    return ModelLinks<SceneType, T, N>(TableLinks<SceneType, T, double, N>(table_, drives_, size_, placement_),
                                       base_body_, waters_, rotors_);
  }
  /// Whether the link that carries a rotor is inboard of its joint.
  constexpr bool carries(const LinkParameters& link, int parent) const {
    int inboard = parent;
    while (inboard > link.rotor_carrier && inboard >= 0)
      inboard = table_[inboard].parent;
    return link.rotor_carrier == LinkParameters::previous || inboard == link.rotor_carrier;
  }

  TreeLinkConstants<double> table_[N] = {};
  DriveConstants<double> drives_[N] = {};
  TreeLinkConstants<double> base_body_{};
  WaterConstants<double> waters_[N + 1] = {};
  RotorConstants<double> rotors_[N] = {};
  Placement placement_{};
  detail::ModelDrives<Model, N, Scene::template has<SharedDrives>> shared_{};
  int size_ = 0;
};

}  // namespace axial

#include <axial/options/end.hpp>
