// Attributes of an element: its own, and those of the default class that it is of.
#pragma once

#include <host_sim/robots/import/mjcf/element.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace importer::mjcf {

class Attributes {
 public:
  /// Of these elements, the first that has an attribute gives it: the element itself stands in front.
  explicit Attributes(std::vector<const Element*> elements) : elements_(std::move(elements)) {}

  bool has(const std::string& name) const { return owner(name) != nullptr; }
  std::string word(const std::string& name, const std::string& otherwise) const;
  /// Refuses a word that is none of these.
  std::string one_of(const std::string& name, const std::vector<std::string>& words) const;
  bool flag(const std::string& name, bool otherwise) const;
  /// As many finite numbers; empty where there is no such attribute.
  std::vector<double> numbers(const std::string& name, std::size_t least, std::size_t most) const;
  double number(const std::string& name, double otherwise) const;
  /// "arm.xml, line 12: joint 'elbow'"
  std::string here() const;
  /// Throws description::Refused: where, what, remedy.
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy) const;
  /// Refuses the element's own attributes and those of its classes that are not among these words.
  void allow(const std::string& words) const;
  /// The one of several words of which attributes the element itself has, or else its classes; refuses two.
  std::string only_one(const std::vector<std::string>& names) const;

 private:
  const Element* owner(const std::string& name) const;

  std::vector<const Element*> elements_;
};

/// Default classes: nested ones have what those around them have, but for what they give themselves.
class Defaults {
 public:
  /// Of an MJCF's root. Refuses classes without a name, of one name, and nested ones of no class.
  explicit Defaults(const Element& root);

  /// Attributes of an element of a kind ("joint", "geom", ..., "actuator" for all actuators), below a childclass.
  Attributes of(const Element& element, const std::string& kind, const std::string& childclass) const;
  /// Refuses a class that is not there.
  void check(const Element& element, const std::string& name) const;

 private:
  void add(const Element& element, const std::string& parent, bool top);

  struct Class {
    std::string parent;                                           ///< empty: none
    std::map<std::string, std::vector<const Element*>> elements;  ///< by kind, the last first
  };
  std::map<std::string, Class> classes_;
};

/// Whether an element of <actuator>, or of a class, is an actuator's.
bool is_actuator(const std::string& name);

}  // namespace importer::mjcf
