#pragma once

#include "fem/pipeline/analysis/profile_scatter.h"
#include "fem/pipeline/coupling/contact_report.h"
#include "fem/pipeline/study/study.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

/// Results of `run` and `mesh` about the points of a drawn profile, and what these leave open.
namespace stemware::pipeline
{

/// The standard error of the terminal spin that follows from the scatter of a drawn profile's points [rad/s];
/// nothing where there is none.
std::optional<double> spin_error(const std::optional<ProfileScatter> &scatter);

/// How far the crown rises over half of the contact @p load [m].
double sag_over_contact(const Study &study, const LoadReport &load);

/// Facts for the template "profile": how well the points fix the rim, what that leaves open of the spin
/// beside @p band [rad/s], and where the crown is not determined: it rises over the contact @p load by less
/// than the points scatter, or its error is half of it. Null where the points have no scatter.
nlohmann::ordered_json profile_facts(const Study &study, const LoadReport &load,
                                     const std::optional<ProfileScatter> &scatter,
                                     const std::optional<double> &band);

/// The rows of shown_chain() with one more, "scatter of the profile", which has the standard error of the
/// spin beside the bands.
nlohmann::ordered_json with_scatter_row(nlohmann::ordered_json chain,
                                        const std::optional<ProfileScatter> &scatter);

/// "profile" of summary.json: the rim with its covariance, null where it has none.
nlohmann::ordered_json profile_summary(const Study &study);

/// profile_summary() with what the scatter leaves open of the spin under @p load.
nlohmann::ordered_json profile_summary(const Study &study, const LoadReport &load,
                                       const std::optional<ProfileScatter> &scatter);

} // namespace stemware::pipeline
