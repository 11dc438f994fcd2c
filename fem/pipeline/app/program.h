#pragma once

namespace stemware::pipeline
{

/// The program `stemware`, from its arguments (the first is its name) to its exit code; to be called once in
/// a process, which is then over but for its end: signals, MPI and the streams are the program's.
int run_program(int argc, char *argv[]);

} // namespace stemware::pipeline
