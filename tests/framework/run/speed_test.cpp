// Timing without a clock in the tests: what is counted, who is timed how often, and what the rows are.
#include "run/speed.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "metrics/registry.h"
#include "run/empty_sampler.h"

namespace moire::test {

namespace {

class NoFrame final : public Frame {
 public:
  ImageSize size() const override { return {4, 2}; }
  void trace(std::span<const SamplePoint>, std::span<Hit>, Counters&) const override {}
};

// Counts how often it is asked to begin, and claims 5 queries and 3 steps a block.
class Counting final : public Sampler {
 public:
  explicit Counting(int& begun) : begun_(begun) {}
  std::unique_ptr<Rendering> begin(const RenderRequest&) const override {
    ++begun_;
    return std::make_unique<Work>();
  }

 private:
  class Work final : public Rendering {
   public:
    void render(PixelBlock& block) const override { block.counters += {.queries = 5, .steps = 3}; }
  };
  int& begun_;
};

Settings rounds(std::int64_t count, double at_most = 1e5) {
  Settings settings(speed_description.parameters);
  settings.set("rounds", count);
  settings.set("at_most", at_most);
  return settings;
}

}  // namespace

TEST_CASE("a quantile is interpolated between the sorted values") {
  CHECK(quantile({3, 1, 2}, 0.5) == 2);
  CHECK(quantile({4, 1, 3, 2}, 0.5) == 2.5);
  CHECK(quantile({4, 1, 3, 2}, 0.25) == 1.75);
  CHECK(quantile({5, 1}, 0) == 1);
  CHECK(quantile({5, 1}, 1) == 5);
  CHECK(quantile({7}, 0.25) == 7);
}

TEST_CASE("every contender has all rows of the pass, and work is counted a pixel") {
  int begun = 0;
  const NoFrame frame;
  const Contender floor("nothing", make_empty_sampler()), counting("counting", std::make_unique<Counting>(begun));
  const auto rows =
      measure_speed("a scene", {{&floor, &frame}, {&counting, &frame}}, rounds(3), 1, Workers(1), [](double) {});
  std::vector<Quantity> quantities(speed_description.quantities.begin(), speed_description.quantities.end());
  std::erase_if(quantities, [](const Quantity& q) { return q.name == "speed.ms_per_next_frame"; });
  REQUIRE(rows.size() == 2 * quantities.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Quantity& quantity = quantities[k % quantities.size()];
    CHECK(rows[k].scene == "a scene");
    CHECK(rows[k].sampler == (k < quantities.size() ? "nothing" : "counting"));
    CHECK(rows[k].metric == quantity.name);
    CHECK(rows[k].unit == quantity.unit);
    CHECK(std::isfinite(rows[k].value));
  }
  CHECK(rows[6].value == 5.0 / 8);  // speed.queries_per_pixel of the second
  CHECK(rows[7].value == 3.0 / 8);  // speed.steps_per_pixel
  CHECK((rows[4].low <= rows[4].value && rows[4].value <= rows[4].high));
  CHECK(begun == 1 + 3 * 2);  // warm-up; each round on one thread and on all
}

TEST_CASE("what is too slow to repeat is timed once, without warm-up and without a spread") {
  int begun = 0;
  const NoFrame frame;
  const Contender slow("slow", std::make_unique<Counting>(begun));
  const auto rows = measure_speed("a scene", {{&slow, &frame, true}}, rounds(5), 1, Workers(1), [](double) {});
  CHECK(begun == 2);  // on one thread, on all
  CHECK(std::isnan(rows[0].low));
  CHECK(std::isnan(rows[0].high));
}

TEST_CASE("a contender that continues is also timed where it goes on from its last rendering") {
  // Notes how many renderings came before each, as its previous one says.
  class Continuing final : public Sampler {
    struct Work final : Rendering {
      explicit Work(int n) : before(n) {}
      void render(PixelBlock&) const override {}
      int before;
    };

   public:
    explicit Continuing(std::vector<int>& all) : all_(all) {}
    std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
      const auto* previous = dynamic_cast<const Work*>(request.previous);
      CHECK((previous != nullptr) == (request.previous != nullptr));
      all_.push_back(previous ? previous->before + 1 : 0);
      return std::make_unique<Work>(all_.back());
    }

   private:
    std::vector<int>& all_;
  };
  const NoFrame frame;
  for (const bool continues : {true, false}) {
    CAPTURE(continues);
    std::vector<int> before;
    const Contender contender("a", std::make_unique<Continuing>(before), continues);
    const auto rows = measure_speed("a scene", {{&contender, &frame}}, rounds(3), 1, Workers(1), [](double) {});
    const auto next =
        std::find_if(rows.begin(), rows.end(), [](const Row& row) { return row.metric == "speed.ms_per_next_frame"; });
    CHECK((next != rows.end()) == continues);
    // Warm-up, then each round: on one thread, on all, and one that goes on from the one of the round before.
    std::sort(before.begin(), before.end());
    CHECK(before == (continues ? std::vector{0, 0, 0, 0, 0, 0, 0, 1, 2, 3} : std::vector(7, 0)));
    if (!continues) continue;
    CHECK(next->unit == "ms");
    CHECK((next->low <= next->value && next->value <= next->high));
  }
}

TEST_CASE("no further round begins after the time is up, but the first is done in any case") {
  int begun = 0;
  const NoFrame frame;
  const Contender counting("counting", std::make_unique<Counting>(begun));
  measure_speed("a scene", {{&counting, &frame}}, rounds(1000, 0), 1, Workers(1), [](double) {});
  CHECK(begun == 1 + 2);
}

TEST_CASE("progress is told the share of rounds done") {
  std::vector<double> shares;
  const NoFrame frame;
  const Contender floor("nothing", make_empty_sampler());
  measure_speed("a scene", {{&floor, &frame}}, rounds(4), 1, Workers(1),
                [&](double share) { shares.push_back(share); });
  CHECK(shares == std::vector{0.25, 0.5, 0.75, 1.0});
}

}  // namespace moire::test
