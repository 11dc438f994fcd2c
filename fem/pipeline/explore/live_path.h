#pragma once

#include "fem/pipeline/coupling/elastic_foot.h"
#include "fem/pipeline/study/study.h"
#include "ring_model/spin/leaning_load.h"
#include "ring_model/spin_search.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// Terminal spin with its contact.
struct LiveBalance
{
  ring::ZeroGuess spin;
  fem::ContactState contact;
};

/// Sequence of balances of a study whose entries are changed interactively, for predicting the next balance.
class LivePath
{
public:
  /// Records the change of an entry; NaN if it is not a number.
  void change(const std::string &entry, double from, double to) { changes.push_back({ entry, from, to }); }
  /// Appends the balance of the present study; std::nullopt restarts the sequence.
  void append(std::optional<LiveBalance> found);
  /// Returns the last balance, extrapolated linearly if the same entry changes again; std::nullopt without a
  /// balance.
  std::optional<LiveBalance> expected() const;

private:
  struct Move
  {
    std::string entry;
    double from, to;
  };

  std::vector<LiveBalance> balances; ///< the last two, the newest last
  std::vector<Move> changes;         ///< since the last balance
  std::optional<Move> last_move;     ///< change between the two balances, if it was one entry's
};

/// Returns the balance of @p study near @p near with friction of the load's first @p n_harmonics, and the
/// truncated load: zero of the torque by the secant method to 1e-8 rad/s, with two or three contacts of @p
/// foot, whose rings are chosen. Returns std::nullopt if the method leaves the neighbourhood or the study is
/// not in balance at every spin. Throws fem::ContactFailure.
std::optional<std::pair<LiveBalance, ring::LeaningLoad>>
balance_near(const LiveBalance &near, const Study &study, const std::shared_ptr<ElasticFoot> &foot,
             unsigned int n_harmonics);

} // namespace stemware::pipeline
