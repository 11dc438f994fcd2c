#pragma once

#include "fem/pipeline/support/failures.h"

#include <string>
#include <utility>
#include <vector>

namespace stemware::pipeline
{

/// English sentence and its values. Faces in other languages have the sentence by its key.
struct Sentence
{
  std::string key, text; ///< text with its values
  std::vector<std::string> values;
};

/// Returns @p text with @p values in the places of {0}, {1} and so on. Braces within a value stay.
Sentence sentence(const std::string &key, const std::string &text,
                  const std::vector<std::string> &values = {});

/// BadInput whose sentence has a key.
class KeyedInput : public BadInput
{
public:
  explicit KeyedInput(Sentence given)
      : BadInput(given.text)
      , sentence(std::move(given))
  {
  }

  const Sentence sentence;
};

/// Throws KeyedInput with @p given unless @p condition holds.
void ensure(bool condition, const Sentence &given);

} // namespace stemware::pipeline
