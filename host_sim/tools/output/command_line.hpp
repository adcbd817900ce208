// How a program begins and ends: options in, exit status out. CLI11 reads the options, and stays out of the mains: its
// header takes the compiler four seconds.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace host_sim {

/// What an option demands of its value; --help tells it.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option& required();
  Option& show_default();
  Option& expected(int values);
  Option& existing_file();
  Option& one_of(const std::vector<std::string>& values);
  /// For an int, a double or a std::uint64_t.
  template <class T>
  Option& range(T lowest, T highest);

 private:
  CLI::Option* option_;
};

/// Options of a program, or of one of its verbs. They are written to the values when the line is read.
class OptionList {
 public:
  explicit OptionList(CLI::App* app) : app_(app) {}
  /// For the types at the end of command_line.cpp.
  template <class T>
  Option option(const std::string& name, T& value, const std::string& text = {});
  void flag(const std::string& name, bool& value, const std::string& text = {});

 protected:
  CLI::App* app_;
};

/// A program's options, and its verbs, one of which must then be given; the program's options may follow a verb.
class CommandLine : public OptionList {
 public:
  explicit CommandLine(const std::string& text, const std::string& name = {});
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The job is done while the line is read.
  OptionList verb(const std::string& name, const std::string& text, const std::function<void()>& job);

  /// Reads the options, does the job, tells on standard error what went wrong, after the program's name.
  /// Returns the job's status; 0 after --help, 2 for options that are refused, 1 for an exception.
  int run(int count, char** arguments, const std::function<int()>& job);

 private:
  std::unique_ptr<CLI::App> owned_;
};

}  // namespace host_sim
