#pragma once

namespace underact::test {

/// What this thread has done in functions of the C library so far: a step for each call, and for each eight bytes that
/// are compared, searched or allocated (to be copied to).
long steps();

}  // namespace underact::test
