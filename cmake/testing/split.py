"""One part of a test source: heavy sources are compiled as several programs, each with some of the tests and what these need.

usage: split.py SOURCE K N OUTPUT
Plain tests go to the parts in turn, in the source's order; of a typed suite every part has all tests for some of the types, which keep
the numbers that they have in the whole source. So the parts' tests are those of the source, each once, under the same names.
"""
import pathlib
import re
import sys

# A test begins and ends in the first column, as clang-format has it.
TEST = re.compile(r"^(TEST|TEST_F)\((\w+),\s*(\w+)\) \{(?:.*\}\n|.*\n(?:(?!\}).*\n)*\}\n)", re.MULTILINE)
SUITE = re.compile(r"^(TYPED_TEST_SUITE\(|INSTANTIATE_TYPED_TEST_SUITE_P\(\w+, )(\w+),\s*([\w:]+)(,\s*[\w:]+)?\);\n", re.MULTILINE)
HELPERS = """#include <gtest/gtest.h>
#include <string>
#include <tuple>
#include <utility>
namespace split {{
template <class List>
struct Part;
template <class... T>
struct Part<testing::Types<T...>> {{
  static constexpr std::size_t part = {part}, parts = {parts};
  static_assert(sizeof...(T) >= parts, "a typed suite of fewer types than parts; ask for fewer parts");
  template <std::size_t... I>
  static auto pick(std::index_sequence<I...>) -> testing::Types<std::tuple_element_t<I * parts + part, std::tuple<T...>>...>;
  using type = decltype(pick(std::make_index_sequence<(sizeof...(T) + parts - 1 - part) / parts>{{}}));
}};
template <class List>
using Types = typename Part<List>::type;
/// The number that a type has in the whole source.
struct Numbers {{
  template <class>
  static std::string GetName(int i) {{
    return std::to_string(i * {parts} + {part});
  }}
}};
}}  // namespace split
"""


def part_of(text, part, parts):
    """The source of a part, 0 to parts - 1, line for line."""
    count = iter(range(len(text)))
    text = TEST.sub(lambda block: block[0] if next(count) % parts == part else "\n" * block[0].count("\n"), text)
    return SUITE.sub(lambda suite: f"{suite[1]}{suite[2]}, split::Types<{suite[3]}>{suite[4] or ', split::Numbers'});\n"
                     + "\n" * (suite[0].count("\n") - 1), text)


def main(source, number, count, output):
    source, part, parts = pathlib.Path(source), int(number) - 1, int(count)
    text = part_of(source.read_text(encoding="utf-8"), part, parts)
    pathlib.Path(output).write_text(HELPERS.format(part=part, parts=parts) + f'#line 1 "{source}"\n' + text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
