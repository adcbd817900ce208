// A text as XML, before anything is read from it.
#pragma once

#include <filesystem>
#include <string>

class TiXmlDocument;

namespace importer {

/// Parses. Throws description::Refused for an empty file, one that is no text, elements nested too deeply for a parser
/// that recurses, more elements than any robot has, and malformed XML.
void parse_xml(const std::string& text, const std::string& from, TiXmlDocument& document);

/// Where a file is that another one includes: in this folder or below it, wherever links lead. Refuses others at a
/// place of the text that includes it.
std::filesystem::path included_path(const std::string& place, const std::filesystem::path& folder,
                                    const std::string& name);

/// The name of the first element of a text, without parsing: what kind of file it is. Empty where there is none.
std::string first_element(const std::string& text);

}  // namespace importer
