// The payload estimator in fixed point: sums in 96 bits, of an observer's residuals in their formats.
#pragma once

#include <axial/control/payload_estimator.hpp>
#include <axial/fixed/control/payload_sums.hpp>

#include <axial/options/begin.hpp>

namespace axial::detail {

template <class Word>
struct PayloadSumOf<Stored<Word>> {
  using type = integer::WideSum;
};
template <class S, class Word, class Tuning>
struct ResidualInput<S, Stored<Word>, Tuning> {
  using type = Residuals<S, Stored<Word>, Tuning>;
};

}  // namespace axial::detail

#include <axial/options/end.hpp>
