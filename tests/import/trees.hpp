#pragma once
/// What a reader has made of a file, by name.

#include <host_sim/robots/import/engine.hpp>

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace trees {

inline const importer::SourceLink& link(const importer::EngineTree& found, const std::string& name) {
  for (const auto& each : found.tree.links)
    if (each.name == name) return each;
  throw description::Refused("no link " + name);
}
inline const importer::SourceJoint& joint(const importer::EngineTree& found, const std::string& name) {
  for (const auto& each : found.tree.links)
    if (each.joint.name == name) return each.joint;
  throw description::Refused("no joint " + name);
}
inline std::string said(const importer::EngineTree& found) {
  std::string text;
  for (const auto& note : found.tree.notes)
    text += note + "\n";
  return text;
}
inline bool says(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }
inline void expect_near(const std::array<double, 3>& ours, const std::array<double, 3>& theirs) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(ours[k], theirs[k], 1e-13) << k;
}

}  // namespace trees
