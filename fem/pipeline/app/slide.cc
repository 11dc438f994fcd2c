#include "fem/pipeline/analysis/slide.h"

#include "fem/pipeline/app/console_progress.h"
#include "fem/pipeline/app/options.h"
#include "fem/pipeline/report/publish.h"
#include "fem/pipeline/report/slide_results.h"
#include "fem/pipeline/study/quantity_text.h"
#include "fem/pipeline/study/study_checks.h"
#include "fem/pipeline/support/failures.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <map>

namespace stemware::pipeline
{

namespace
{

/// Options of `stemware slide`.
struct SlideOptions : StudyOptions
{
  SlideQuestion question;
  std::string speed = "1 m/s", spin = "20 rad/s", inner_radius = "0 m"; ///< as they were written
};

/// The number in an option, in the SI unit @p unit. Throws BadInput where it is none, or @p is_allowed says
/// no.
template <typename Allowed>
double option_value(const std::string &option, const std::string &text, const std::string &unit,
                    const std::string &words, const Allowed &is_allowed)
{
  const auto value = parse_quantity(text, unit);
  const std::string given = option + " = " + shortened(text);
  if (const std::string trouble = trouble_with_unit(text, unit); !value && !trouble.empty())
    throw BadInput(given + trouble);
  require(value && is_allowed(*value), given + " is not allowed; give " + words + " (" + unit + ").");
  return *value;
}

/// The question with the options read. Throws BadInput.
SlideQuestion read_question(const SlideOptions &options)
{
  SlideQuestion question = options.question;
  const auto in_range = [](double value) { return std::abs(value) <= 1e6; };
  const auto is_speed = [](double value) { return 1e-6 <= value && value <= 1e3; };
  const auto is_length = [](double value) { return 0 <= value && value <= 1e3; };
  question.speed = option_value("--speed", options.speed, "m/s", "a speed between 1e-6 and 1000", is_speed);
  question.spin = option_value("--spin", options.spin, "rad/s", "a spin between -1e6 and 1e6", in_range);
  question.inner_radius =
    option_value("--inner-radius", options.inner_radius, "m", "a length between 0 and 1000", is_length);
  return question;
}

/// Follows a body that is pushed and let go, and writes the folder of its results. Collective over all ranks.
/// Throws as study_slide(), and OutputFailure.
void slide(const SlideOptions &options)
{
  // 1. What slides, and how it is pushed.
  Stopwatch stopwatch;
  ConsoleProgress progress(stopwatch);
  const SlideQuestion question = read_question(options);
  const Study study = begin_study(options);
  check_slide(study, question);
  say_note("Unused    ", idle_note(idle_in_slide(study, question.body)));
  ResultsFolder folder(options.results_place());
  stopwatch.finish("input");

  // 2. Its way to the stop.
  const SlideStudy result = study_slide(study, question, progress);

  // 3. The answer, and the results, all at once.
  publish(options, study, tabulate(study, result), folder, stopwatch);
}

} // namespace

void add_slide_verb(CLI::App &program, Verb &chosen)
{
  const auto [verb, options] =
    add_study_verb(program, chosen, "slide", "Push a glass, a ring or a disc, let it go, follow it", slide);
  static const std::map<std::string, SlidingBodyKind> kinds = { { "glass", SlidingBodyKind::glass },
                                                                { "ring", SlidingBodyKind::ring },
                                                                { "annulus", SlidingBodyKind::annulus },
                                                                { "disc", SlidingBodyKind::disc } };
  verb
    ->add_option("--body", options->question.body,
                 "What slides: glass, ring, annulus or disc; default: glass")
    ->transform(CLI::Validator(
      [](std::string &name)
      {
        const auto kind = kinds.find(CLI::detail::to_lower(name));
        if (kind == kinds.end())
          return shortened(name) + " is not allowed; give glass, ring, annulus or disc";
        name = std::to_string(static_cast<int>(kind->second));
        return std::string();
      },
      ""))
    ->type_name("BODY");
  verb->add_option("--speed", options->speed, "Speed of the push; default: 1 m/s")->type_name("\"1 m/s\"");
  verb->add_option("--spin", options->spin, "Spin of the push, positive counter-clockwise; default: 20 rad/s")
    ->type_name("\"20 rad/s\"");
  verb->add_option("--inner-radius", options->inner_radius, "Inner radius of an annulus")
    ->type_name("\"20 mm\"");
}

} // namespace stemware::pipeline
