// Integer primitives of fixed point: products, sine-cosine pairs of binary angles, reciprocals. No branch, no overflow,
// the same bits on every processor and compiler.
#pragma once

#include <axial/fixed/words/integer_product.hpp>
#include <axial/fixed/words/integer_reciprocal.hpp>
#include <axial/fixed/words/integer_sincos.hpp>
