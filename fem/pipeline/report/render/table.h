#pragma once

#include "fem/pipeline/document/table.h"
