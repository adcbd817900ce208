// How a program begins and ends: options in, exit status out.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace host_sim {

/// Reads a program's options, does its job, tells on standard error what went wrong, after the app's name.
/// Returns the job's status; 0 after --help, 2 for options that are refused, 1 for an exception.
template <class Job>
int run_program(CLI::App& app, int count, char** arguments, Job job) {
  try {
    app.parse(count, arguments);
    return job();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), error.what());
    return 1;
  }
}

}  // namespace host_sim
