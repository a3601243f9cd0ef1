// Path data: every command against places worked out by hand, and mistakes with the character where they are.
#include <catch2/catch_test_macros.hpp>

#include "message_of.h"
#include "plugins/cartoon/drawn.h"

namespace moire::test {
namespace {

std::string path(std::string_view data) { return shown(drawn(data)); }
std::string problem(std::string_view data) {
  return message_of([&] { drawn(data); });
}

}  // namespace

TEST_CASE("straight commands of path data, absolute and relative") {
  CHECK(path("M 1 2 L 3 4 H 7 V 9 Z") == "M 1,2 L 3,4 L 7,4 L 7,9");
  CHECK(path("m 1 2 l 3 4 h 7 v 9 z") == "M 1,2 L 4,6 L 11,6 L 11,15");
  CHECK(path("M1 2 3 4 5 6") == "M 1,2 L 3,4 L 5,6");
  CHECK(path("m1 2 3 4 5 6") == "M 1,2 L 4,6 L 9,12");
  CHECK(path("M0 0 H1 2 3 V4 5") == "M 0,0 L 1,0 L 2,0 L 3,0 L 3,4 L 3,5");
  CHECK(path("M0 0 h1 2 3 v4 5") == "M 0,0 L 1,0 L 3,0 L 6,0 L 6,4 L 6,9");
}

TEST_CASE("curves of path data, absolute and relative") {
  CHECK(path("M 1 1 C 2 3 4 5 6 7") == "M 1,1 C 2,3 4,5 6,7");
  CHECK(path("M 1 1 c 2 3 4 5 6 7") == "M 1,1 C 3,4 5,6 7,8");
  CHECK(path("M 1 1 Q 2 3 4 5") == "M 1,1 Q 2,3 4,5");
  CHECK(path("M 1 1 q 2 3 4 5") == "M 1,1 Q 3,4 5,6");
  // Repeated: each begins where the last one ended.
  CHECK(path("M0 0 c 1 0 2 1 2 2 1 0 2 1 2 2") == "M 0,0 C 1,0 2,1 2,2 C 3,2 4,3 4,4");
}

TEST_CASE("smooth curves reflect the control point before, or begin without one") {
  CHECK(path("M 0 0 C 1 2 3 4 5 5 S 8 9 10 10") == "M 0,0 C 1,2 3,4 5,5 C 7,6 8,9 10,10");
  CHECK(path("M 0 0 c 1 2 3 4 5 5 s 3 4 5 5") == "M 0,0 C 1,2 3,4 5,5 C 7,6 8,9 10,10");
  CHECK(path("M 0 0 S 1 2 3 4 5 6 7 8") == "M 0,0 C 0,0 1,2 3,4 C 5,6 5,6 7,8");
  CHECK(path("M 0 0 Q 1 2 3 3 T 6 6 9 9") == "M 0,0 Q 1,2 3,3 Q 5,4 6,6 Q 7,8 9,9");
  CHECK(path("M 0 0 q 1 2 3 3 t 3 3") == "M 0,0 Q 1,2 3,3 Q 5,4 6,6");
  CHECK(path("M 1 2 T 3 4") == "M 1,2 Q 1,2 3,4");
  // Only a curve of its own kind has one to reflect.
  CHECK(path("M 0 0 Q 1 2 3 3 S 8 9 10 10") == "M 0,0 Q 1,2 3,3 C 3,3 8,9 10,10");
  CHECK(path("M 0 0 C 1 2 3 4 5 5 T 8 8") == "M 0,0 C 1,2 3,4 5,5 Q 5,5 8,8");
  CHECK(path("M 0 0 C 1 2 3 4 5 5 L 6 6 S 8 9 10 10") == "M 0,0 C 1,2 3,4 5,5 L 6,6 C 6,6 8,9 10,10");
}

TEST_CASE("contours end and begin") {
  CHECK(path("M 0 0 L 1 0 L 1 1 Z M 5 5 L 6 5 L 6 6 Z") == "M 0,0 L 1,0 L 1,1 M 5,5 L 6,5 L 6,6");
  CHECK(path("m 1 1 l 1 0 z m 5 5 l 1 0") == "M 1,1 L 2,1 M 6,6 L 7,6");
  // After Z the next command goes on from where the contour began.
  CHECK(path("M 1 1 L 2 1 L 2 2 Z L 9 9") == "M 1,1 L 2,1 L 2,2 M 1,1 L 9,9");
  CHECK(path("M 1 1 L 2 1 L 2 2 z l 1 2") == "M 1,1 L 2,1 L 2,2 M 1,1 L 2,3");
  CHECK(path("M 9 9 M 1 1 L 2 2") == "M 1,1 L 2,2");
}

TEST_CASE("numbers need nothing between them that is not needed to tell them apart") {
  CHECK(path("M1.5.5-3e2,+4L.25-.75") == "M 1.5,0.5 L -300,4 L 0.25,-0.75");
  CHECK(path("M0,0L1e-1 2E+1 3.,4") == "M 0,0 L 0.1,20 L 3,4");
  CHECK(path(" \t\r\nM\n1 , 2\nL 3\f4 ") == "M 1,2 L 3,4");
}

TEST_CASE("the flags of arcs may stand without anything after them") {
  const std::string spaced = path("M 0 0 A 5 5 0 0 1 10 0 A 5 5 0 1 0 0 0");
  CHECK(path("M0 0A5 5 0 0110 0A5 5 0 100 0") == spaced);
  CHECK(path("M0 0A5 5 0 01 10 0A5 5 0 1 00 0") == spaced);
  CHECK(path("m0 0a5 5 0 0110 0a5 5 0 10-10 0") == spaced);
  CHECK(path("m0 0a5,5,0,0,1,10,0,5,5,0,1,0,-10,0") == spaced);
}

TEST_CASE("path data that is empty draws nothing, and so does a move alone") {
  CHECK(path("") == "");
  CHECK(path("  \n ") == "");
  CHECK(path("M 1 2") == "");
  CHECK(path("M 1 2 z M 3 4 z") == "");
}

TEST_CASE("mistakes in path data are told with the character where they are") {
  CHECK(problem("L 1 2") == "character 1: begins with \"L\"; path data begins with \"M\" or \"m\"");
  CHECK(problem("1 2") == "character 1: has \"1 2\" where a command is expected; commands are MmLlHhVvCcSsQqTtAaZz");
  CHECK(problem("M 1 2 L 3 Z") == "character 11: \"L\" has 1 of 2 numbers (then \"Z\"); it takes x y");
  CHECK(problem("M 1 2 L") == "character 8: \"L\" has 0 of 2 numbers (then the end); it takes x y");
  CHECK(problem("M 1 2 L 3 4 5") == "character 14: \"L\" has 1 of 2 numbers (then the end); it takes x y");
  CHECK(problem("M 1 2 C 1 2 3 4 5 Q") ==
        "character 19: \"C\" has 5 of 6 numbers (then \"Q\"); it takes x1 y1 x2 y2 x y");
  CHECK(problem("M 0 0 A 5 5 0 2 1 10 0") ==
        "character 15: \"A\" has 3 of 7 numbers (then \"2 1 10 0\", no flag); it takes rx ry angle large-arc-flag "
        "sweep-flag x y");
  CHECK(problem("M 1 2 L 3,,4") == "character 11: \"L\" has 1 of 2 numbers (then \",4\"); it takes x y");
  CHECK(problem("M 1 2 L 3 4,") == "character 12: has a comma that no number follows; remove the comma");
  CHECK(problem("M 1 2 X 3 4") ==
        "character 7: has \"X 3 4\" where a command is expected; commands are MmLlHhVvCcSsQqTtAaZz");
  CHECK(problem("M 1 2 L nan 4") == "character 9: \"L\" has 0 of 2 numbers (then \"nan 4\"); it takes x y");
  CHECK(problem("M 1 2 L 1e999 4") == "character 7: \"L\" reaches coordinate inf; at most 1e+09 can be drawn");
  CHECK(problem("M 1 2 l 1e9 4") == "character 7: \"l\" reaches coordinate 1e+09; at most 1e+09 can be drawn");
  CHECK(problem("M 1 2 A 1e10 1 0 0 0 3 4") ==
        "character 7: \"A\" reaches coordinate 1e+10; at most 1e+09 can be drawn");
  CHECK(problem("M 1 2 A 1 1 1e999 0 0 3 4") == "character 7: \"A\" is turned by inf degrees; at most 1e+09 are taken");
  CHECK(problem("M 1 2 Z 3 4") ==
        "character 9: has \"3 4\" where a command is expected; commands are MmLlHhVvCcSsQqTtAaZz");
}

}  // namespace moire::test
