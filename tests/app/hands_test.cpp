#include "app/hands.h"

#include <gtest/gtest.h>

namespace halsted::app {
namespace {

/// A session ends with its scripts only where nobody's hand is on a device.
TEST(Hands, AreAPersonsWithAMouseOrADevice) {
  for (const char* device : {"mouse", "falcon", "falcon:A1", "open", "vendor:Default Device"}) EXPECT_TRUE(heldByPerson(parseDevice("--right", device))) << device;
  for (const char* device : {"virtual", "script:expert.toml"}) EXPECT_FALSE(heldByPerson(parseDevice("--right", device))) << device;
}

}  // namespace
}  // namespace halsted::app
