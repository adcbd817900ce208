// Instead of the reader, where there is no libsdformat.
#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/sdf/sdf_reader.hpp>

namespace importer {

EngineTree read_sdf(const std::string&, const std::string& from, const ReadingOptions&) {
  throw description::Refused(from +
                             ": this is an SDF, and libsdformat, which reads it, was not there when this was built; "
                             "install libsdformat-dev (./axial import does where it can), or give a URDF or an MJCF");
}

}  // namespace importer
