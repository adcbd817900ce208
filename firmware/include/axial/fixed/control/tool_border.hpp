// A payload and a tool that changes at the border between real numbers and fixed point, and a payload in its frame.
#pragma once
#include <axial/scalar/language.hpp>

#include <axial/fixed/control/limits.hpp>
#include <axial/fixed/links/fixed_links.hpp>
#include <axial/fixed/words/real_words.hpp>

#include <axial/options/begin.hpp>

namespace axial {

/// A payload after a conversion, and whether it is one that the robot may carry.
template <class Word>
struct ConvertedPayload {
  PayloadBody<Stored<Word>> load{};  ///< in the formats of InputFormats
  Status status{};                   ///< payload_limit, not_finite; about no joint
};

/// A payload (kg, m and kg m^2 in the last link's frame; mounted_payload() brings it there) in the formats of the
/// scene's robot, each number to nearest. One that is no payload, or beyond what the robot declares, has a status; then
/// in.payload keeps the one before. Integers alone, as to_fixed().
template <class S, class Word, class T>
[[nodiscard]] constexpr ConvertedPayload<Word> to_fixed_payload(const PayloadBody<T>& load) {
  using F = InputFormats<detail::described_by<S>, Stored<Word>>;
  bool finite = true;
  const auto nearest = [&finite](const T& x, int exponent) {
    finite = finite & is_finite(x);
    return Stored<Word>{detail::to_word<Word>(x, exponent)};
  };
  const auto com = [&](const T& x) { return nearest(x, F::payload_com); };
  const auto inertia = [&](const T& x) { return nearest(x, F::payload_inertia); };
  const auto& j = load.inertia_com;
  ConvertedPayload<Word> result;
  result.load = {nearest(load.mass, F::payload_mass),
                 {com(load.com.x), com(load.com.y), com(load.com.z)},
                 {inertia(j.xx), inertia(j.yy), inertia(j.zz), inertia(j.xy), inertia(j.xz), inertia(j.yz)}};
  result.status = finite ? check_payload<S>(result.load) : Status{Status::Code::not_finite, -1};
  return result;
}

/// A tool after a conversion, and whether it is one that the robot has room for.
template <class Word>
struct ConvertedTool {
  Pose<Mat3<Vec3<Stored<Word>>>, Vec3<Stored<Word>>> tool{};  ///< in the formats of InputFormats
  Status status{};                                            ///< input_limit, not_finite; about no joint
};

/// A tool's pose in the last link's frame (m; axes as columns) in the formats of the scene's robot, each number to
/// nearest. One that is no frame, or beyond tool_limit(), has a status; then in.tool keeps the one before. Integers
/// alone, as to_fixed().
template <class S, class Word, class T>
[[nodiscard]] constexpr ConvertedTool<Word> to_fixed_tool(const Pose<Mat3<Vec3<T>>, Vec3<T>>& pose) {
  using F = InputFormats<detail::described_by<S>, Stored<Word>>;
  bool finite = true;
  const auto words = [&finite](const Vec3<T>& v, int exponent) {
    const T parts[] = {v.x, v.y, v.z};
    for (const T& x : parts) {
      const bool is_real = is_finite(x);
      finite = finite & is_real;
    }
    return Vec3<Stored<Word>>{{detail::to_word<Word>(v.x, exponent)},
                              {detail::to_word<Word>(v.y, exponent)},
                              {detail::to_word<Word>(v.z, exponent)}};
  };
  const auto& axes = pose.rotation;
  ConvertedTool<Word> result;
  result.tool = {{words(axes.x, F::sine_cosine), words(axes.y, F::sine_cosine), words(axes.z, F::sine_cosine)},
                 words(pose.position, F::tool)};
  const bool within = detail::tool_within<S>(result.tool);
  result.status.code = !finite ? Status::Code::not_finite : within ? Status::Code::ok : Status::Code::input_limit;
  return result;
}

/// A payload given in the frame of a tool, as in.payload takes it: `tool` is in.tool, `held` has the formats of a
/// payload, mounted_payload<Robot>(in.tool, held). The centre of mass is off by half a unit of its words, an entry of
/// the inertia by 5. input_limit: the tool is none; payload_limit: what the last link would carry is beyond what the
/// robot declares. The same instructions whatever the words are.
template <class S, class Word>
[[nodiscard]] constexpr ConvertedPayload<Word> mounted_payload(
    const Pose<Mat3<Vec3<Stored<Word>>>, Vec3<Stored<Word>>>& tool, const PayloadBody<Stored<Word>>& held) {
  using Scene = scene_of<S>;
  using A = detail::ArithmeticOf<Scene, Word>;
  using F = InputFormats<detail::described_by<S>, Stored<Word>>;
  constexpr int com = F::payload_com, inertia = F::payload_inertia, with_room = inertia - 2;  // rows reach root 3
  // Further out nothing that is held could be within the declared reach; nearer, excesses are seen.
  constexpr double much = 5.0 * F::load.com_reach;
  constexpr double furthest = F::tool_limit.reach < much ? F::tool_limit.reach : much;
  const auto pose = read_tool<Scene, A>(tool);
  const auto load = read_payload<Scene, A>(held);
  const auto& r = pose.rotation;
  const auto& j = load.inertia_com;
  bool lost = false;
  const auto along = [&](const auto& axis) {
    return Vec3{round_to<with_room>(j.xx * axis.x + j.xy * axis.y + j.xz * axis.z),
                round_to<with_room>(j.xy * axis.x + j.yy * axis.y + j.yz * axis.z),
                round_to<with_room>(j.xz * axis.x + j.yz * axis.y + j.zz * axis.z)};
  };
  const auto entry = [&lost](const auto& axis, const auto& row) {
    return Stored<Word>{saturated<inertia>(lost, dot(axis, row)).raw};
  };
  const auto centre = [&](const auto& axis, const auto& origin) {
    return Stored<Word>{saturated<com>(lost, origin + dot(axis, load.com)).raw};
  };
  const auto x = along(r.x), y = along(r.y), z = along(r.z);
  ConvertedPayload<Word> result;
  result.load = {held.mass,
                 {centre(r.x, pose.position.x), centre(r.y, pose.position.y), centre(r.z, pose.position.z)},
                 {entry(r.x, x), entry(r.y, y), entry(r.z, z), entry(r.x, y), entry(r.x, z), entry(r.y, z)}};
  const bool is_tool = detail::tool_within<S>(tool), is_close = detail::within_length(tool.position, furthest, F::tool);
  const bool is_near = is_close & !lost;
  const Status mounted = check_payload<S>(result.load);
  result.status.code = !is_tool ? Status::Code::input_limit : is_near ? mounted.code : Status::Code::payload_limit;
  return result;
}

}  // namespace axial

#include <axial/options/end.hpp>
