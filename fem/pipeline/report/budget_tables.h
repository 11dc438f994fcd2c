#pragma once

#include "fem/pipeline/document/budget_rows.h"
