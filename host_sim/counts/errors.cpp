#include <host_sim/counts/errors.hpp>
#include <host_sim/counts/forms.hpp>
#include <robots/models/models.hpp>

#include <cstdio>

namespace counts {

namespace {

template <class R>
void add_errors(std::vector<Errors>& result) {
  std::fprintf(stderr, "counts: forward errors of %s\n", R::name);
  const auto in_float = errors_of<R, float>(), in_double = errors_of<R, double>();
  std::size_t i = 0;
  for_each_form<R>([&](auto form) {
    result.push_back({R::name, form.algorithm, form.parameters, in_float[i], in_double[i]});
    ++i;
  });
}

}  // namespace

std::vector<Errors> errors(const std::string& robot) {
  std::vector<Errors> result;
  robots::AllAndModels::for_each([&](auto named) {
    if (robot.empty() || robot == named.name) add_errors<typename decltype(named)::Robot>(result);
  });
  return result;
}

}  // namespace counts
