#include <host_sim/robots/description/known_robots.hpp>
#include <host_sim/robots/description/table.hpp>
#include <host_sim/robots/identification/robot_file.hpp>
#ifdef AXIAL_WITH_URDF
#include <host_sim/robots/import/importer.hpp>
#endif

namespace host_sim::identification {

namespace {

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() > ending.size() && text.substr(text.size() - ending.size()) == ending;
}

#ifdef AXIAL_WITH_URDF
description::Description read_urdf(const std::string& path, const std::string& tip) {
  importer::Options options;
  options.reading.tip = tip;
  options.as_published = true;  // a nominal model is to be improved, whatever it is
  const auto result = importer::import_file(path, options);
  if (!result.figures.good())
    throw description::Refused("'" + path + "' misses the bounds of its verification; see ./axial import");
  return result.imported.robot;
}
#else
description::Description read_urdf(const std::string& path, const std::string&) {
  throw description::Refused("'" + path + "': this program was built without urdfdom; install liburdfdom-dev");
}
#endif

}  // namespace

description::Description find_robot(const std::string& robot, const std::string& tip) {
  if (ends_with(robot, ".urdf")) return read_urdf(robot, tip);
  if (!tip.empty()) throw description::Refused("--tip is for a URDF; '" + robot + "' is none");
  if (ends_with(robot, ".json")) {
    auto table = description::to_mdh(description::read_table(robot));
    table.as_published = true;
    return table;
  }
  if (robot.find_first_of("./") != std::string::npos)
    throw description::Refused("'" + robot + "' is neither a URDF (.urdf) nor a Denavit-Hartenberg table (.json)");
  return description::known_robot(robot);
}

}  // namespace host_sim::identification
