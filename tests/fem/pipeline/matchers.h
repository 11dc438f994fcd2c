#pragma once

// The macro Assert of deal.II has the name of a function of GoogleMock.
#pragma push_macro("Assert")
#undef Assert
#include <gmock/gmock.h>
#pragma pop_macro("Assert")
