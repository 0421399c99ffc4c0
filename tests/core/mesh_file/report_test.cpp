#include "core/mesh_file/report.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace underact::mesh_file {
namespace {

using Sentences = std::vector<Sentence>;

Facts closedFacts() {
  Facts facts;
  facts.file_faces = facts.faces = 12;
  facts.corners = 8;
  facts.parts = facts.closed_parts = 1;
  facts.thinnest = 10.0;
  facts.crossings_checked = 1;
  return facts;
}

const std::string kClosed = "The mesh is closed: it can be felt from both sides, or as a wall from outside or inside.";

TEST(MeshReport, SaysOneSentenceOfASoundMesh) {
  EXPECT_EQ(reportOf(closedFacts(), 1.0), Sentences{kClosed});
  EXPECT_TRUE(allowsWalls(closedFacts()));
}

TEST(MeshReport, SaysWhatWasLeftOut) {
  Facts facts = closedFacts();
  facts.not_finite = 1;
  facts.out_of_range = 2;
  facts.without_extent = 1;
  facts.duplicates = 3;
  EXPECT_EQ(reportOf(facts, 1.0), (Sentences{"1 face was left out: one of its vertices is not a finite point.",
                                             "2 faces were left out: they refer to vertices that are not in the file.",
                                             "1 face was left out: it has no extent.",
                                             "3 faces were left out: they are duplicates.", kClosed}));
}

TEST(MeshReport, SaysWhatWasRepairedInMillimetres) {
  Facts facts = closedFacts();
  facts.welded = 28;
  facts.weld_tolerance = 1.7320508e-5;
  facts.added_at_seams = 1;
  facts.turned = 1;
  facts.normals = 12;
  facts.normals_against = 7;
  EXPECT_EQ(reportOf(facts, 1000.0),
            (Sentences{"28 vertices were merged with others at the same position, or nearer than 0.0173 mm.",
                       "1 vertex lies on an edge of another face. This face was divided there: the seam is no hole.",
                       "1 face was turned over so that neighbours agree on which side is outside.",
                       "Most normals in the file point against the order of the vertices. Only the order counts here: "
                       "if outside and inside feel swapped, save the mesh with its faces turned over.",
                       kClosed}));
  facts.normals_against = 6;  // half is not most
  EXPECT_EQ(reportOf(facts, 1000.0).size(), 4U);
}

TEST(MeshReport, SaysWhatIsLeftAndWhatItMeans) {
  Facts facts = closedFacts();
  facts.parts = 3;
  facts.nested_parts = 2;
  facts.hollows = 1;
  facts.borders = 1;
  facts.border_edges = 4;
  facts.longest_border = 40.0;
  facts.crowded_edges = 1;
  facts.clashing_edges = 2;
  facts.crossings = 9;
  facts.flat_faces = 2;
  facts.thinnest = 0.25;
  EXPECT_EQ(
      reportOf(facts, 1.0),
      (Sentences{
          "The mesh consists of 3 separate parts, 2 inside others. 1 of these is a hollow, which is felt from within.",
          "The surface is open: 1 border, 40 mm long. The stylus can pass through the hole.",
          "1 edge has more than two faces.",
          "The surface has no outside: at 2 edges its faces cannot agree, as on a Möbius strip.",
          "The surface intersects itself, at 9 pairs of faces.",
          "2 faces are as narrow as a line. They are kept because such faces close seams.",
          "Part of it is thin, 0.25 mm on average: felt from both sides, it may let the stylus through; a wall does "
          "not.",
          "The mesh can be felt from both sides only: it is open, so it has no inside."}));
  EXPECT_FALSE(allowsWalls(facts));
  facts.hollows = 0;  // a body in a body is none
  EXPECT_EQ(partsReport(facts), "The mesh consists of 3 separate parts, 2 inside others.");
}

TEST(MeshReport, SaysWhyThereIsNoWall) {
  Facts facts = closedFacts();
  facts.crowded_edges = 1;
  EXPECT_EQ(noWallsReason(facts), "edges with more than two faces leave the inside undefined");
  facts.clashing_edges = 1;
  EXPECT_EQ(noWallsReason(facts), "its faces cannot agree on an outside");
  facts = {};
  EXPECT_EQ(noWallsReason(facts), "it has no faces");
  EXPECT_EQ(reportOf(facts, 1.0), Sentences{"No face is left, so there is nothing to feel."});
}

TEST(MeshReport, SaysWhereCrossingsWereNotLookedFor) {
  Facts facts = closedFacts();
  facts.crossings_checked = 0;
  EXPECT_EQ(reportOf(facts, 1.0)[0],
            "The check for self-intersection was left out or not completed: there are too many faces, or too many near "
            "each other.");
  facts.crossings = 3;
  EXPECT_EQ(reportOf(facts, 1.0)[0], "The surface intersects itself, at 3 pairs of faces or more.");
}

TEST(MeshReport, SaysWhatIsFeltOfAMeshThatIntersectsItself) {
  Facts facts = closedFacts();
  facts.crossings = 4;
  facts.within = 1;
  facts.inside = Inside::United;
  EXPECT_EQ(reportOf(facts, 1.0),
            (Sentences{"The surface intersects itself, at 4 pairs of faces. You feel the surface of the whole body, "
                       "without walls inside it: 1 face there was left out.",
                       kClosed}));
  EXPECT_TRUE(allowsWalls(facts));
  facts.crossings = 0;
  facts.within = 0;
  facts.crowded_edges = 2;  // bodies that meet in an edge
  EXPECT_EQ(reportOf(facts, 1.0)[1],
            "Parts touch or contain each other. You feel the surface of the whole body, without walls inside it.");
  EXPECT_TRUE(allowsWalls(facts));
}

TEST(MeshReport, RefusesAWallWhereInsideCannotBeTold) {
  Facts facts = closedFacts();
  facts.crossings = 1'000'000;
  facts.inside = Inside::Unsure;
  EXPECT_FALSE(allowsWalls(facts));
  EXPECT_EQ(reportOf(facts, 1.0),
            (Sentences{
                "The surface intersects itself, at 1000000 pairs of faces. Inside and outside cannot be distinguished.",
                "The mesh can be felt from both sides only: it intersects itself too often to tell inside from "
                "outside."}));
}

std::vector<double> scalesOf(double largest_mm) {
  std::vector<double> scales;
  const auto proposal = implausible(largest_mm);
  if (proposal) std::ranges::transform(proposal->units, std::back_inserter(scales), &Unit::mm_per_unit);
  return scales;
}

TEST(Units, AreAskedForWhereTheSizeIsImplausible) {
  EXPECT_EQ(implausible(0.12)->sentence,
            "Read as millimetres, the mesh is 0.12 mm long. In metres it would be 120 mm.");
  EXPECT_EQ(scalesOf(0.12), (std::vector<double>{1000.0}));
  EXPECT_EQ(scalesOf(1.0), (std::vector<double>{1000.0, 10.0, 25.4}));
  EXPECT_EQ(implausible(1.0)->sentence,
            "Read as millimetres, the mesh is 1 mm long. In metres it would be 1000 mm. In centimetres it would be 10 "
            "mm. In inches it would be 25.4 mm.");
  EXPECT_EQ(implausible(120'000.0)->sentence,
            "Read as millimetres, the mesh is 120000 mm long. In micrometres it would be 120 mm.");
}

TEST(Units, AreNotAskedForWhereItIsPlausible) {
  for (const double size_mm : {5.0, 120.0, 2000.0, 0.0}) EXPECT_FALSE(implausible(size_mm)) << size_mm;
  EXPECT_TRUE(implausible(4.999));
  EXPECT_TRUE(implausible(2000.1));
}

TEST(Units, ReportsThatNoUnitFits) {
  EXPECT_EQ(implausible(1e-6)->sentence,
            "Read as millimetres, the mesh is 0.000001 mm long. That is too small to feel: state a larger scale.");
  EXPECT_TRUE(implausible(1e12)->units.empty());
}

}  // namespace
}  // namespace underact::mesh_file
