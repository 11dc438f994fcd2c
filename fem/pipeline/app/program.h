#pragma once

namespace stemware::pipeline
{

/// Runs the program `stemware` (argv[0] is its name) and returns the exit code. Call once per process: it
/// takes over signals, MPI and the standard streams.
int run_program(int argc, char *argv[]);

} // namespace stemware::pipeline
