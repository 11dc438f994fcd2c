#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/leaning_load.h"
#include "ring_model/spin_search.h"

#include <memory>
#include <optional>
#include <utility>

namespace stemware::pipeline
{

/// Terminal spin with its contact.
struct LiveBalance
{
  ring::ZeroGuess spin;
  fem::ContactState contact;
};

/// Returns the balance of @p study near @p near with friction of the load's first @p n_harmonics, and the
/// truncated load: zero of the torque by the secant method to 1e-8 rad/s, with two or three contacts of @p
/// foot, whose rings are chosen. Returns std::nullopt if the method leaves the neighbourhood or the study is
/// not in balance at every spin. Throws fem::ContactFailure.
std::optional<std::pair<LiveBalance, ring::LeaningLoad>>
balance_near(const LiveBalance &near, const Study &study, const std::shared_ptr<ElasticFoot> &foot,
             unsigned int n_harmonics);

} // namespace stemware::pipeline
