"""How a page's output is held against a command's: shown.py by itself."""

import unittest

from shown import difference, rounds_to


class Rounding(unittest.TestCase):
    def test_a_number_stands_for_all_that_round_to_it(self):
        self.assertTrue(rounds_to("0.1606156", "0.161"))
        self.assertTrue(rounds_to("0.1605", "0.161"))
        self.assertFalse(rounds_to("0.1606156", "0.160"))
        self.assertFalse(rounds_to("0.1606156", "0.15"))
        self.assertTrue(rounds_to("1.93e-13", "2e-13"))
        self.assertFalse(rounds_to("1.2e-12", "1e-13"))
        self.assertTrue(rounds_to("60000", "60000"))
        self.assertFalse(rounds_to("60001", "60000"))
        self.assertTrue(rounds_to("-0.04", "-0.0"))


class Output(unittest.TestCase):
    def test_words_numbers_and_gaps(self):
        printed = '{"ticks": 60000, "recorded": {"rms_error_mm": 11.629, "a": -1}, "max": 0.7}'
        shown = '{"ticks": 60000, "recorded": {"rms_error_mm": 11.6, ...},\n "max": 0.7}'
        self.assertIsNone(difference(shown, printed))
        for wrong in (
            '{"ticks": 60001, ...}',
            '{"ticks": 60000, ..., "a": 1}, "max": 0.7}',
            '{"ticks": 60000, ..., "least": 0.7}',
            '{"ticks": 60000}',
        ):
            self.assertIsNotNone(difference(wrong, printed), wrong)

    def test_a_table_may_have_other_spaces_but_no_other_words(self):
        printed = "Mass    45.0086      0.0077    g   45\nFriction  0.26\n"
        self.assertIsNone(difference("Mass 45.009  0.008  g  45\n...", printed))
        said = difference("Mass 45.02 0.008 g 45\n...", printed)
        self.assertEqual(said, "45.02 is shown, 45.0086 is printed")
        self.assertIsNotNone(difference("Mass 45.009 0.008 kg 45\n...", printed))

    def test_names_with_digits_are_words(self):
        self.assertIsNotNone(difference("first.h5 02_sphere", "first.h6 02_sphere"))
        self.assertIsNotNone(difference("first.h5 02_sphere", "first.h5 03_sphere"))

    def test_where_a_clock_decides_numbers_are_not_compared(self):
        self.assertIsNone(difference("took 3 ms", "took 4 ms", numbers_count=False))
        self.assertIsNotNone(difference("took 3 ms", "took 4 s", numbers_count=False))


if __name__ == "__main__":
    unittest.main()
