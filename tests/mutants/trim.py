"""A test source with the tests that a filter names alone: the others are compiled for every mutant and never run."""

import fnmatch
import re

# A test begins and ends in the first column, as clang-format has it. Parameterised ones are registered by name elsewhere: they stay.
BLOCK = re.compile(r"^(TEST|TEST_F|TYPED_TEST)\((\w+),\s*(\w+)\) \{(?:.*\}\n|.*\n(?:(?!\}).*\n)*\}\n)", re.MULTILINE)
TYPES = 64  # at most, of a typed suite


def names(kind, suite, test):
    """What GoogleTest calls the test, or the tests, of a block."""
    return [f"{suite}/{i}.{test}" for i in range(TYPES)] if kind == "TYPED_TEST" else [f"{suite}.{test}"]


def selects(tests, name):
    """Whether GoogleTest's filter, patterns between colons, selects a name."""
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in tests.split(":"))


def only_type(text, tests):
    """With one type of a typed suite where the filter names one by its number, and the filter that fits: it is the first one then."""
    named = re.fullmatch(r"(\w+)/(\d+)\.([\w*]+)", tests)
    suite = named and re.search(rf"^TYPED_TEST_SUITE\({named[1]}, (\w+)((?:, [\w:]+)?)\);\n", text, re.MULTILINE)
    if not suite:
        return text, tests
    one = (f"template <class> struct OnlyType;\n"
           f"template <class... T> struct OnlyType<testing::Types<T...>> {{\n"
           f"  using type = testing::Types<std::tuple_element_t<{named[2]}, std::tuple<T...>>>;\n}};\n"
           f"TYPED_TEST_SUITE({named[1]}, OnlyType<{suite[1]}>::type{suite[2]});\n")
    return "#include <tuple>\n" + text.replace(suite[0], one), f"{named[1]}/0.{named[3]}"


def only_tests(text, tests):
    """The source's text without the tests that the filter does not select; no filter, or one that excludes: as it is."""
    if not tests or "-" in tests or "?" in tests:
        return text
    return BLOCK.sub(lambda block: block[0] if any(selects(tests, name) for name in names(*block.groups()[:3])) else "", text)


def trimmed(text, tests):
    """only_tests, of one type where the filter has one; and the filter for it."""
    return only_type(only_tests(text, tests), tests)
