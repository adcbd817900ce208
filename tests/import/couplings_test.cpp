// Mimics and transmissions of a small arm: ratios and friction by hand, and the comparison sees what is wrong.
#include <host_sim/robots/import/importer.hpp>

#include "arms.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace {

std::string changed(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}
const std::string axis = "<axis xyz=\"0 1 1\"/>";
const std::string follower = changed(arms::urdf, axis,
                                     axis +
                                         "<dynamics damping=\"4\" friction=\"2\"/>"
                                         "<mimic joint=\"shoulder\" multiplier=\"0.25\" offset=\"0.01\"/>");
const std::string four_bar = changed(arms::urdf, "</robot>",
                                     "<transmission name=\"rods\"><type>x/FourBarLinkageTransmission</type>"
                                     "<joint name=\"elbow\"><role>joint2</role></joint><joint name=\"shoulder\"><role>"
                                     "joint1</role><mechanicalReduction>2</mechanicalReduction></joint></transmission>"
                                     "</robot>");

TEST(Couplings, ThatJoinNothingMayLeaveOutTheirGear) {
  const auto imported = [](const std::string& reduction) {
    return importer::import_text(changed(arms::urdf, "</robot>",
                                         "<transmission name=\"own\"><type>x/SimpleTransmission</type><joint "
                                         "name=\"elbow\"/><actuator name=\"motor\"><mechanicalReduction>" +
                                             reduction +
                                             "</mechanicalReduction></actuator></transmission>"
                                             "</robot>"),
                                 "arm", {});
  };
  const auto said = [&](const std::string& reduction) {
    const auto& notes = imported(reduction).imported.robot.notes;
    const auto own =
        std::find_if(notes.begin(), notes.end(), [](const auto& note) { return note.find("'own'") != note.npos; });
    return own == notes.end() ? std::string() : *own;
  };
  EXPECT_EQ(said("1"), "");
  EXPECT_NE(said("100").find("reduction 100, the gear"), std::string::npos) << said("100");
  EXPECT_NE(said("gear").find("mechanicalReduction 'gear' is not a number"), std::string::npos) << said("gear");
  EXPECT_TRUE(imported("gear").figures.good());
}
TEST(Couplings, OfAFollowerTakeItsFrictionToTheDrive) {
  const auto result = importer::import_text(follower, "arm", {});
  EXPECT_TRUE(result.figures.good());
  const auto& links = result.imported.robot.links;
  EXPECT_DOUBLE_EQ(links[0].parameters.viscous, 0.3 + 0.25 * 0.25 * 4.0);
  EXPECT_DOUBLE_EQ(links[0].parameters.coulomb_backward, -0.2 - 0.25 * 2.0);
  EXPECT_EQ(links[1].parameters.viscous, 0.0);
  EXPECT_EQ(description::drive_matrix(result.imported.robot).drives, 1);
  auto wrong = result.imported;
  wrong.robot.links[1].parameters.drives.offset += 1e-6;
  const auto reference = importer::reference_of(follower, {}, {}, {}, {"shoulder", "elbow"}, "");
  EXPECT_GT(importer::verify(wrong, reference, 1, 20).pose, 1e-7);
}
TEST(Couplings, OfAFourBarAreItsLinearLaw) {
  const auto result = importer::import_text(four_bar, "arm", {});
  EXPECT_TRUE(result.figures.good());
  const auto g = description::drive_matrix(result.imported.robot);
  EXPECT_EQ(g.ratio[0][0], 0.5);
  EXPECT_EQ(g.ratio[1][0], -0.5);
  EXPECT_EQ(g.ratio[1][1], 1.0);
}
TEST(Couplings, NameAJointOnceAndOneThatHasADrive) {
  const auto refusal = [](const std::string& text) {
    try {
      importer::import_text(text, "arm", {});
    } catch (const description::Refused& refused) {
      return std::string(refused.what());
    }
    return std::string();
  };
  const auto rods = four_bar.substr(four_bar.find("<transmission"));
  EXPECT_NE(refusal(changed(changed(four_bar, "</robot>", rods), "\"rods\"", "\"bars\""))
                .find("is in transmission 'bars' too"),
            std::string::npos);
  EXPECT_NE(refusal(changed(follower, "</robot>", rods)).find("'elbow' mimics 'shoulder' and has drives"),
            std::string::npos);
}
TEST(Couplings, OfAJointThatDoesNotMoveLeaveTheOtherAsItIs) {
  for (const std::string still : {"flange", "knee"}) {
    const auto result = importer::import_text(
        changed(four_bar, "<joint name=\"shoulder\"><role>", "<joint name=\"" + still + "\"><role>"), "arm", {});
    EXPECT_TRUE(result.figures.good());
    const auto g = description::drive_matrix(result.imported.robot);
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k)
        EXPECT_EQ(g.ratio[i][k], i == k ? 1.0 : 0.0);
    const auto& notes = result.imported.robot.notes;
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [&](const auto& note) {
      return note.find("joint '" + still + "' does not move here: the other one is taken as its own") != note.npos;
    }));
  }
}
TEST(Couplings, ThatAreWrongAreSeen) {
  const auto imported = importer::import_text(four_bar, "arm", {}).imported;
  const auto reference =
      importer::reference_of(four_bar, {}, imported.changes, {0.0, 0.0, -9.81}, {"shoulder", "elbow"}, "");
  EXPECT_TRUE(importer::verify(imported, reference, 1, 20).good());
  auto wrong = imported;
  wrong.robot.links[1].parameters.drives.ratio[0] *= -1.0;
  EXPECT_GT(importer::verify(wrong, reference, 1, 20).torque, 1e-3);
  auto still = imported;  // poses alone
  still.frames.clear();
  still.robot.links[0].parameters.drives.ratio[0] *= 1.001;
  EXPECT_GT(importer::verify(still, reference, 1, 20).mass_matrix, 1e-6);
}

}  // namespace
