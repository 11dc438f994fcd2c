#pragma once

// GoogleMock's matchers, also behind deal.II, whose macro Assert has the name of one of GoogleMock's
// functions.
#pragma push_macro("Assert")
#undef Assert
#include <gmock/gmock.h>
#pragma pop_macro("Assert")
