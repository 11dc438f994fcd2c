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

/// A terminal spin, and the contact there.
struct LiveBalance
{
  ring::ZeroGuess spin;
  fem::ContactState contact;
};

/// The balances of a study while somebody moves its entries one after the other: where the next one is to be
/// looked for.
class LivePath
{
public:
  /// An entry has got another value; NaN where it takes no numbers.
  void change(const std::string &entry, double from, double to) { changes.push_back({ entry, from, to }); }
  /// Goes on to the balance of the study as it is now; nothing: it has none, the path begins anew.
  void append(std::optional<LiveBalance> found);
  /// The last balance, moved on in a straight line where the entry moves again that has moved before; nothing
  /// without one.
  std::optional<LiveBalance> expected() const;

private:
  struct Move
  {
    std::string entry;
    double from, to;
  };

  std::vector<LiveBalance> balances; ///< the last two, the newest last
  std::vector<Move> changes;         ///< since the last balance
  std::optional<Move> last_move;     ///< from the first of `balances` to the second, where it was one entry's
};

/// The balance of @p study next to @p near with the friction of the load's first @p n_harmonics, and its load
/// of these: the zero of the torque by the secant method to 1e-8 rad/s, with two or three contacts of @p
/// foot, whose rings are chosen. Nothing where it leaves the neighbourhood or the study is not in balance at
/// every spin. Throws fem::ContactFailure.
std::optional<std::pair<LiveBalance, ring::LeaningLoad>>
balance_near(const LiveBalance &near, const Study &study, const std::shared_ptr<ElasticFoot> &foot,
             unsigned int n_harmonics);

} // namespace stemware::pipeline
