#include "run/failure_message.h"

#include <catch2/catch_test_macros.hpp>
#include <new>
#include <stdexcept>

namespace moire::test {

TEST_CASE("whatever is thrown, there is something to say") {
  CHECK(failure_message(std::make_exception_ptr(std::runtime_error("the disk is full"))) == "the disk is full");
  CHECK(failure_message(std::make_exception_ptr(std::bad_alloc())) == "out of memory");
  CHECK(failure_message(std::make_exception_ptr(42)) == "threw something that is no std::exception");
}

}  // namespace moire::test
