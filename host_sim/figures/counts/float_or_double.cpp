#include <host_sim/figures/counts/float_or_double.hpp>

#include <functional>

namespace counts {

namespace {

bool in_float() { return FloatOrDouble::precision == Precision::in_float; }

// Of floats where they are floats: a value that was rounded before stays what it is.
template <class Operation, class... Doubles>
FloatOrDouble compute(Operation operation, Doubles... values) {
  return FloatOrDouble::constant(in_float() ? static_cast<double>(operation(static_cast<float>(values)...))
                                            : operation(values...));
}

template <class T>
axial::SinCos<FloatOrDouble> sincos_in(double x) {
  const auto pair = axial::sincos(static_cast<T>(x));
  return {FloatOrDouble::constant(static_cast<double>(pair.sin)),
          FloatOrDouble::constant(static_cast<double>(pair.cos))};
}

}  // namespace

double FloatOrDouble::value() const { return in_float() ? static_cast<double>(static_cast<float>(value_)) : value_; }

FloatOrDouble FloatOrDouble::operator-() const { return compute(std::negate<>(), value_); }
FloatOrDouble operator+(FloatOrDouble a, FloatOrDouble b) { return compute(std::plus<>(), a.value_, b.value_); }
FloatOrDouble operator-(FloatOrDouble a, FloatOrDouble b) { return compute(std::minus<>(), a.value_, b.value_); }
FloatOrDouble operator*(FloatOrDouble a, FloatOrDouble b) { return compute(std::multiplies<>(), a.value_, b.value_); }
FloatOrDouble operator/(FloatOrDouble a, FloatOrDouble b) { return compute(std::divides<>(), a.value_, b.value_); }
bool operator<(FloatOrDouble a, FloatOrDouble b) { return a.value() < b.value(); }
bool operator>(FloatOrDouble a, FloatOrDouble b) { return a.value() > b.value(); }
axial::SinCos<FloatOrDouble> sincos(FloatOrDouble x) {
  return in_float() ? sincos_in<float>(x.value_) : sincos_in<double>(x.value_);
}

}  // namespace counts

counts::FloatOrDouble axial::NumberTraits<counts::FloatOrDouble>::epsilon() {
  using counts::FloatOrDouble;
  return FloatOrDouble::constant(counts::in_float() ? static_cast<double>(NumberTraits<float>::epsilon())
                                                    : NumberTraits<double>::epsilon());
}
