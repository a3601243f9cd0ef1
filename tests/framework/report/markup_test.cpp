#include "report/markup.h"

#include <catch2/catch_test_macros.hpp>

namespace moire::report {

TEST_CASE("text cannot become an element nor end an attribute") {
  CHECK(tag("p", {{"title", "a\"><script>"}}, "<b> & 'c'").text() ==
        "<p title=\"a&quot;&gt;&lt;script&gt;\">&lt;b&gt; &amp; &#39;c&#39;</p>");
}

TEST_CASE("markup inside markup stays as it is") {
  CHECK(tag("ul", tag("li", "1 < 2") + tag("li", "b")).text() == "<ul><li>1 &lt; 2</li><li>b</li></ul>");
  CHECK(void_tag("input", {{"checked", ""}}).text() == "<input checked=\"\">");
}

}  // namespace moire::report
