// What one component of a lazy sum consists of, and what rounding it costs: the rules of words/terms.hpp on exponents.
#pragma once

#include <axial/fixed/balls/ball.hpp>

#include <axial/options/begin.hpp>

namespace axial::bounds {

/// The terms of one component, as far as rounding depends on them. A term that is zero in every state is none: it
/// rounds nothing. `most_words` of them are words at most.
template <int most_words>
class TermsOf {
 public:
  /// A word at an exponent.
  constexpr void add_word(int exponent) { words_[word_count_++] = exponent; }  // one too many is no constant expression
  /// A constant of the model, which takes the exponent of the sum.
  constexpr void add_literal() { ++literals_; }
  /// A product of two words, whose exponents add up to `exponent`.
  constexpr void add_product(int exponent) {
    coarsest_ = exponent < least_ ? 1 : coarsest_ + (exponent == least_ ? 1 : 0);
    least_ = axial::detail::smaller(least_, exponent);
    upper_units_ += axial::detail::power_of_two(-exponent), ++products_;
  }
  /// A constant of the model times a word at `exponent` that reaches `size`.
  constexpr void add_scaled(double constant, int exponent, double size) {
    const int top = top_bit(constant);
    limit_ = axial::detail::smaller(limit_, exponent - top);
    by_word_ += size * axial::detail::power_of_two(exponent), by_constant_ += size * axial::detail::power_of_two(top);
    ++scaled_;
  }
  /// The terms of another sum.
  constexpr void add(const TermsOf& other) {
    for (int i = 0; i < other.word_count_; ++i)
      add_word(other.words_[i]);
    literals_ += other.literals_, products_ += other.products_, scaled_ += other.scaled_;
    coarsest_ = (other.least_ <= least_ ? other.coarsest_ : 0) + (least_ <= other.least_ ? coarsest_ : 0);
    least_ = axial::detail::smaller(least_, other.least_), upper_units_ += other.upper_units_;
    limit_ = axial::detail::smaller(limit_, other.limit_);
    by_word_ += other.by_word_, by_constant_ += other.by_constant_;
  }

  /// How far the sum, rounded into `exponent`, is from what its terms add up to.
  constexpr double rounding(int exponent, const WordRounding& r) const {
    if (products_ + scaled_ == 0) return of_words(exponent, r) + literals_ * 0.5 * r.ulp(exponent);
    return r.high_word ? of_upper_words(exponent, r) : of_products(exponent, r);
  }

 private:
  static constexpr int none = 100000;
  int words_[most_words] = {}, word_count_ = 0, literals_ = 0;
  int products_ = 0, least_ = none, coarsest_ = 0;  // of words; how many of them have the least exponent
  double upper_units_ = 0.0;                        // sum of the units of products
  int scaled_ = 0, limit_ = none;                   // of scaled words: the exponent that fits, less a word's bits
  double by_word_ = 0.0;                            // sum of the words' raw values
  double by_constant_ = 0.0;                        // sum of their sizes, by the constants' top bits

  // Products that are finer than what they are added at.
  constexpr int finer_than(int common) const { return common < least_ ? products_ : products_ - coarsest_; }
  // A constant of a word of `bits` has the exponent bits - 2 - top: it is less than 2^(top + 1), well within a word.
  static constexpr int top_bit(double constant) {
    const double size = magnitude(constant), room = 1.0 + axial::detail::power_of_two(-13);
    return axial::detail::binary_exponent(size * room);
  }

  // Words move to the exponent one by one, each rounded.
  constexpr double of_words(int exponent, const WordRounding& r) const {
    double error = 0.0;
    for (int i = 0; i < word_count_; ++i)
      error += r.move(words_[i], exponent);
    return error;
  }
  // Products meet at one exponent of a double word; what is finer is cut off there, and the sum is rounded once.
  // Literals are rounded to nearest by the compiler, those of products at what is left of that exponent.
  constexpr double of_products(int exponent, const WordRounding& r) const {
    using axial::detail::smaller;
    const int common = smaller(smaller(exponent + r.bits, least_), limit_ + r.bits - 2);
    double units = literals_ * 0.5 + 0.5 * by_word_ + finer_than(common);
    for (int i = 0; i < word_count_; ++i)
      units += words_[i] > common ? 1.0 : 0.0;
    return units * r.ulp(common) + (common > exponent ? r.store(exponent) : 0.0);
  }
  // Upper words of products: each cut off, those of two variables moved to one exponent first.
  constexpr double of_upper_words(int exponent, const WordRounding& r) const {
    using axial::detail::smaller;
    const int own = limit_ + r.bits - 2, wanted = exponent + r.bits;
    const double literals = own < wanted ? by_constant_ * r.ulp(r.bits - 2) : 0.0;
    const double constants =
        0.5 * (by_word_ * r.ulp(wanted) + literals) + scaled_ * r.ulp(smaller(wanted, own) - r.bits);
    const int variable = smaller(least_ - r.bits, exponent);
    const double products = upper_units_ * r.ulp(-r.bits) + finer_than(variable + r.bits) * r.store(variable);
    return of_words(exponent, r) + literals_ * 0.5 * r.ulp(exponent) + (scaled_ > 0 ? constants : 0.0) +
           (products_ > 0 ? products : 0.0);
  }
};
using Terms = TermsOf<4>;  ///< of what kernels sum

}  // namespace axial::bounds

#include <axial/options/end.hpp>
