#include <host_sim/robots/description/description.hpp>
#include <host_sim/robots/import/mjcf/couplings.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace importer::mjcf {
namespace {

/// Each element of a kind in a section.
template <class Visit>
void each(const Model& model, const char* section, Visit visit) {
  for (const auto& of : model.root.children)
    if (of.name == section)
      for (const auto& element : of.children)
        visit(element);
}

/// A hinge or a slide, or null.
const JointNode* joint_of(const Model& model, const std::string& name) {
  const auto found = model.joint_of_name.find(name);
  if (found == model.joint_of_name.end()) return nullptr;
  const auto& body = model.bodies[static_cast<std::size_t>(found->second.first)];
  const bool is_there = found->second.second < body.joints.size();  // a free joint is not
  return is_there && body.joints[found->second.second].type != "ball" ? &body.joints[found->second.second] : nullptr;
}
const JointNode& existing_joint(const Model& model, const Attributes& a, const std::string& attribute) {
  const auto* joint = joint_of(model, a.word(attribute, ""));
  if (joint == nullptr)
    a.refuse(attribute + " '" + a.word(attribute, "") + "' is no hinge or slide of the file", "mend the name");
  return *joint;
}

/// A joint and what a tendon's length gains by it.
struct Pull {
  const JointNode* joint;
  double coefficient;
};
std::vector<Pull> pulls_of(const Model& model, const Element& tendon) {
  std::vector<Pull> pulls;
  for (const auto& child : tendon.children) {
    const Attributes a({&child});
    if (child.name == "joint") pulls.push_back({&existing_joint(model, a, "joint"), a.number("coef", 0.0)});
  }
  return pulls;
}
const Element* tendon_of(const Model& model, const std::string& name) {
  const auto found = model.tendon_of_name.find(name);
  return found != model.tendon_of_name.end() ? found->second : nullptr;
}

/// Whether a range holds: said, or by being one.
bool is_limited(const Attributes& a, const std::string& said, const std::string& range, const Settings& settings) {
  const std::string word = a.one_of(said, {"auto", "true", "false"});
  const auto values = a.numbers(range, 2, 2);
  if (word != "auto") return word == "true" && !values.empty();
  return settings.limits_by_range && !values.empty() && values[0] < values[1];
}

class Laws {
 public:
  explicit Laws(const Model& model) : model_(model) {
    each(model, "equality", [&](const Element& e) {
      const Attributes a = model.defaults->of(e, "equality", "");
      if (!a.flag("active", true)) return;
      if (e.name == "joint") add_joint(a);
      if (e.name == "tendon") add_tendon(a);
    });
  }
  std::map<std::string, Law> found;

 private:
  void add(const std::string& joint, const Law& law) {
    if (!found.emplace(joint, law).second)
      law.written.refuse("joint '" + joint + "' is determined by another equality too", "keep one of them");
  }
  std::vector<double> polynomial(const Attributes& a) const {
    auto c = a.numbers("polycoef", 1, 5);
    if (c.empty()) c = {0.0, 1.0};
    c.resize(5);
    return c;
  }
  void add_joint(const Attributes& a) {
    const auto& follower = existing_joint(model_, a, "joint1");
    const auto c = polynomial(a);
    Law law{a, "", 0.0, follower.zero + c[0], ""};
    if (a.has("joint2")) {
      const auto& leader = existing_joint(model_, a, "joint2");
      law.leader = c[1] != 0.0 ? leader.name : "", law.ratio = c[1], law.offset -= c[1] * leader.zero;
      if (c[2] != 0.0 || c[3] != 0.0 || c[4] != 0.0)
        law.problem = "polycoef is '" + a.word("polycoef", "") + "': not linear";
    }
    add(follower.name, law);
  }
  void add_tendon(const Attributes& a) {
    const auto* tendon = tendon_of(model_, a.word("tendon1", ""));
    const auto pulls = tendon != nullptr && tendon->name == "fixed" ? pulls_of(model_, *tendon) : std::vector<Pull>{};
    if (pulls.empty() || a.has("tendon2")) return;  // check_tendons
    const auto& last = pulls.back();
    Law law{a, "", 0.0, last.joint->zero, ""};
    if (pulls.size() > 2 || last.coefficient == 0.0) law.problem = "couples more than two joints, or none";
    if (law.problem.empty()) law.offset += polynomial(a)[0] / last.coefficient;
    if (pulls.size() == 2 && law.problem.empty()) {
      law.leader = pulls[0].joint->name, law.ratio = -pulls[0].coefficient / last.coefficient;
      law.offset -= law.ratio * pulls[0].joint->zero;
      if (law.ratio == 0.0) law.leader.clear();
    }
    add(last.joint->name, law);
  }

  const Model& model_;
};

/// The most that an actuator exerts at its output, or none: what its control asks for at most, inside what it may
/// exert.
class Strength {
 public:
  Strength(const Attributes& actuator, const std::string& kind, const Settings& settings) : a_(actuator) {
    if (is_limited(a_, "ctrllimited", "ctrlrange", settings) &&
        (kind == "motor" || (kind == "general" && is_plain()))) {
      const auto gain = a_.numbers("gainprm", 0, 10);
      narrow("ctrlrange", kind == "motor" || gain.empty() ? 1.0 : gain[0]);
    }
    if (is_limited(a_, "forcelimited", "forcerange", settings)) narrow("forcerange", 1.0);
    if (least_ < 0.0 && largest_ > 0.0 && !said_.empty()) most = std::min(-least_, largest_);
    if (least_ != -largest_)
      note = said_ + (most > 0.0 ? ": the smaller side is the limit of both" : ": one-sided, no limit is taken");
  }
  double most = -1.0;  ///< below 0: none
  std::string note;

 private:
  bool is_plain() const {
    return a_.word("gaintype", "fixed") == "fixed" && a_.word("biastype", "none") == "none" &&
           a_.word("dyntype", "none") == "none";
  }
  void narrow(const std::string& attribute, double gain) {
    const auto range = a_.numbers(attribute, 2, 2);
    least_ = std::max(least_, std::min(gain * range[0], gain * range[1]));
    largest_ = std::min(largest_, std::max(gain * range[0], gain * range[1]));
    said_ += (said_.empty() ? "" : ", ") + attribute + " is '" + a_.word(attribute, "") + "'";
  }

  const Attributes& a_;
  double least_ = -std::numeric_limits<double>::infinity(), largest_ = std::numeric_limits<double>::infinity();
  std::string said_;
};

class Efforts {
 public:
  Efforts(const Model& model, SourceTree& tree) : model_(model), tree_(tree) {
    for (const auto& link : tree.links)
      if (link.parent >= 0 && link.joint.moves()) movers_[link.joint.name] = &link.joint;
    each(model, "actuator", [&](const Element& e) { add(e, model.defaults->of(e, "actuator", "")); });
    for (auto& link : tree.links) {
      if (!link.joint.moves()) continue;
      const auto found = drives_.find(link.joint.name);
      if (found != drives_.end() && found->second.bounded) link.joint.effort = found->second.sum;
      cap(link.joint);
    }
  }

 private:
  struct Drive {
    double sum = 0.0;
    bool bounded = true;
  };
  struct Lever {
    std::string leader;
    double ratio = 0.0;
  };

  const SourceJoint* mover_of(const std::string& name) const {
    const auto found = movers_.find(name);
    return found != movers_.end() ? found->second : nullptr;
  }
  /// The joint whose drive moves another one, and how far for a unit of it.
  Lever lever_of(const std::string& joint) {
    Lever lever{joint, 1.0};
    for (const auto* at = mover_of(joint); at != nullptr && !at->leader.empty(); at = mover_of(at->leader))
      lever.leader = at->leader, lever.ratio *= at->ratio;
    return lever;
  }
  void add(const Element& element, const Attributes& a) {
    std::vector<Pull> pulls;
    for (const char* attribute : {"joint", "jointinparent"})
      if (const auto* joint = joint_of(model_, a.word(attribute, "")); joint != nullptr) pulls.push_back({joint, 1.0});
    if (const auto* tendon = a.has("tendon") ? tendon_of(model_, a.word("tendon", "")) : nullptr; tendon != nullptr)
      pulls = pulls_of(model_, *tendon);
    pulls.erase(std::remove_if(pulls.begin(), pulls.end(),
                               [&](const Pull& pull) { return mover_of(pull.joint->name) == nullptr; }),
                pulls.end());
    const std::string name = "actuator '" + a.word("name", element.name) + "'";
    if (pulls.empty()) {
      if (!a.has("joint") && !a.has("jointinparent") && !a.has("tendon"))
        tree_.notes.push_back(name + " is at no joint: it limits none");
      return;
    }
    for (const char* more : {"armature", "damping"})
      if (a.number(more, 0.0) != 0.0)
        a.refuse(std::string(more) + " is '" + a.word(more, "") + "' at the actuator",
                 "give it to the joint, by gear^2");
    drive(a, name, pulls, Strength(a, element.name, model_.settings));
  }
  void drive(const Attributes& a, const std::string& name, const std::vector<Pull>& pulls, const Strength& strength) {
    const auto gear = a.numbers("gear", 1, 6);
    const std::string leader = lever_of(pulls[0].joint->name).leader;
    double lever = 0.0;
    for (const auto& pull : pulls) {
      const Lever by = lever_of(pull.joint->name);
      if (by.leader != leader) return say_several(name, pulls);
      lever += by.ratio * pull.coefficient;
    }
    auto& at = drives_[leader];
    at.sum += std::abs(lever * (gear.empty() ? 1.0 : gear[0])) * strength.most;
    at.bounded = at.bounded && strength.most > 0.0 && lever != 0.0;
    if (!strength.note.empty()) tree_.notes.push_back(name + ": " + strength.note);
  }
  void say_several(const std::string& name, const std::vector<Pull>& pulls) {
    std::string joints;
    for (const auto& pull : pulls)
      joints += (joints.empty() ? "'" : ", '") + pull.joint->name + "'", drives_[pull.joint->name].bounded = false;
    tree_.notes.push_back(name + " pulls joints " + joints +
                          " by one tendon: each is taken with an effort of its own, which one drive cannot give");
  }
  /// What a joint lets through of all its actuators.
  void cap(SourceJoint& joint) const {
    const auto& a = joint_of(model_, joint.name)->attributes;
    const auto range = a.numbers("actuatorfrcrange", 2, 2);
    if (!is_limited(a, "actuatorfrclimited", "actuatorfrcrange", model_.settings)) return;
    if (!(range[0] < 0.0 && range[1] > 0.0)) return;
    const double most = std::min(-range[0], range[1]);
    joint.effort = joint.effort > 0.0 ? std::min(joint.effort, most) : most;
  }

  const Model& model_;
  SourceTree& tree_;
  std::map<std::string, const SourceJoint*> movers_;
  std::map<std::string, Drive> drives_;
};

}  // namespace

std::map<std::string, Law> laws_of(const Model& model) { return Laws(model).found; }

void refuse_loops(const Model& model, const std::function<int(const std::string& body)>& carrier) {
  const auto body_of = [&](const Attributes& a, const std::string& body, const std::string& site) {
    const auto found = model.body_of_site.find(a.word(site, ""));
    if (a.has(site) && found != model.body_of_site.end())
      return model.bodies[static_cast<std::size_t>(found->second)].name;
    return a.word(body, "world");
  };
  each(model, "equality", [&](const Element& e) {
    const Attributes a = model.defaults->of(e, "equality", "");
    if (!a.flag("active", true) || (e.name != "connect" && e.name != "weld" && e.name != "distance")) return;
    const std::string first = body_of(a, "body1", "site1"), second = body_of(a, "body2", "site2");
    const int one = carrier(first), other = carrier(second);
    if (one == other || one == -2 || other == -2) return;
    a.refuse("closes a loop between bodies '" + first + "' and '" + second + "', which is not linear in general",
             "a parallelogram's joints are coupled by <equality><joint polycoef=.../>; or choose a --tip that leaves "
             "the loop beside the chain, where joints are held");
  });
}

void check_tendons(const Model& model, SourceTree& tree) {
  std::set<std::string> moving;
  for (const auto& link : tree.links)
    if (link.parent >= 0 && link.joint.moves()) moving.insert(link.joint.name);
  const auto moves = [&](const Element* tendon) {
    if (tendon == nullptr || tendon->name != "fixed") return tendon != nullptr;
    const auto pulls = pulls_of(model, *tendon);
    return std::any_of(pulls.begin(), pulls.end(),
                       [&](const Pull& pull) { return moving.count(pull.joint->name) != 0; });
  };
  each(model, "tendon", [&](const Element& e) {
    const Attributes a = model.defaults->of(e, "tendon", "");
    for (const char* acts : {"stiffness", "damping", "frictionloss", "armature"})
      if (const auto values = a.numbers(acts, 1, 5); !values.empty() && values[0] != 0.0 && moves(&e))
        a.refuse(std::string(acts) + " is '" + a.word(acts, "") + "': it acts on all joints of the tendon at once",
                 "give the joints their own, or choose a --tip that leaves them beside the chain");
    if (is_limited(a, "limited", "range", model.settings) && moves(&e))
      tree.notes.push_back("limits of tendon '" + a.word("name", "") + "' are of no single joint, and not taken over");
  });
  each(model, "equality", [&](const Element& e) {
    const Attributes a = model.defaults->of(e, "equality", "");
    const auto *first = tendon_of(model, a.word("tendon1", "")), *second = tendon_of(model, a.word("tendon2", ""));
    const bool fixed_alone = first != nullptr && first->name == "fixed" && !a.has("tendon2");
    if (e.name == "tendon" && a.flag("active", true) && !fixed_alone && (moves(first) || moves(second)))
      a.refuse("couples the joints of two tendons, or of one that is not fixed", "write it by <equality><joint>");
  });
}

void set_efforts(const Model& model, SourceTree& tree) { Efforts(model, tree); }

}  // namespace importer::mjcf
