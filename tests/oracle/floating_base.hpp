// A chain on a free body, as a longer chain on a fixed base: six massless carriers, of which the last carries the
// body's inertia, are its degrees of freedom. Lagrange's equations then need nothing new.
#pragma once

#include <oracle/moving_base.hpp>

namespace oracle {

/// Velocity or acceleration of frame 0 in its own axes: angular, and (classically) of its origin.
template <class T>
struct BaseTwist {
  Vec3<T> angular{}, linear{};
};

/// The longer chain with its carriers at position 0, so that frame 0 is turned by R in the root frame.
template <class T>
class FloatingChain {
 public:
  /// `body`: mass, com and inertia of what is fixed to frame 0; chain.gravity is in axes of frame 0.
  FloatingChain(const Chain<T>& chain, const Link<T>& body) : whole_(moving_base::carriers<T>()) {
    for (Link<T>& carrier : whole_.links)
      carrier.inertia = symmetric(T(0), T(0), T(0), T(0), T(0), T(0));
    whole_.links[5].mass = body.mass, whole_.links[5].com = body.com, whole_.links[5].inertia = body.inertia;
    poses_ = link_poses(whole_, Vector<T>(6, T(0)));
    for (Link<T> link : chain.links) {
      link.parent += 6;
      whole_.links.push_back(link);
    }
    whole_.gravity = poses_[5].rotation * chain.gravity;
  }
  const Chain<T>& whole() const { return whole_; }

  /// Carriers' positions (all 0) and then q.
  Vector<T> positions(const Vector<T>& q) const { return joined(Vector<T>(6, T(0)), q); }
  /// Carriers' rates that give frame 0 this velocity, and then qd.
  Vector<T> rates(const BaseTwist<T>& velocity, const Vector<T>& qd) const {
    return joined(components(velocity.angular, velocity.linear), qd);
  }
  /// Carriers' second derivatives for this acceleration, and then qdd.
  Vector<T> second_rates(const BaseTwist<T>& velocity, const BaseTwist<T>& acceleration, const Vector<T>& qdd) const {
    const Vec3<T> known = turning_axes(velocity.angular);
    return joined(components(acceleration.angular - known, acceleration.linear), qdd);
  }
  /// Acceleration of frame 0 from the carriers' second derivatives.
  BaseTwist<T> acceleration(const BaseTwist<T>& velocity, const Vector<T>& second) const {
    return {resultant(second, 3) + turning_axes(velocity.angular), resultant(second, 0)};
  }
  /// What generalised forces or momenta of the carriers are at frame 0: moment about its origin (angular), force.
  BaseTwist<T> wrench(const Vector<T>& generalised) const {
    return {resultant(generalised, 3), resultant(generalised, 0)};
  }
  /// Loads on the links, and a force on the body.
  Load<T> load(const Load<T>& links, const Wrench<T>& on_body) const {
    Load<T> all = links;
    if (all.links.empty()) all.links.resize(whole_.links.size() - 6);
    all.links.insert(all.links.begin(), 6, Wrench<T>{});
    all.links[5] = on_body;
    return all;
  }

 private:
  static Vector<T> joined(Vector<T> first, const Vector<T>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }
  const Vec3<T>& axis(int i) const { return poses_[std::size_t(i)].rotation.c2; }
  Vec3<T> in_frame_0(const Vec3<T>& v) const { return transpose(poses_[5].rotation) * v; }
  Vector<T> components(const Vec3<T>& angular, const Vec3<T>& linear) const {
    Vector<T> result;
    for (int i = 0; i < 6; ++i)
      result.push_back(dot(axis(i), poses_[5].rotation * (i < 3 ? linear : angular)));
    return result;
  }
  Vec3<T> resultant(const Vector<T>& along, int first) const {
    Vec3<T> sum{};
    for (int i = first; i < first + 3; ++i)
      sum = sum + along[std::size_t(i)] * axis(i);
    return in_frame_0(sum);
  }
  /// Angular acceleration that remains when no carrier accelerates: each axis turns with the carriers before it.
  Vec3<T> turning_axes(const Vec3<T>& angular) const {
    const Vec3<T> w = poses_[5].rotation * angular;
    Vec3<T> turning{}, sum{};
    for (int i = 3; i < 6; ++i) {
      const Vec3<T> own = dot(axis(i), w) * axis(i);
      sum = sum + cross(turning, own);
      turning = turning + own;
    }
    return in_frame_0(sum);
  }

  Chain<T> whole_;
  std::vector<Pose<T>> poses_;
};

}  // namespace oracle
