"""Runs test modules: `run.py MODULE...`. Exit status 0, 1, or 77 where something was skipped,
saying what and why.
"""

import sys
import unittest

try:
    suite = unittest.defaultTestLoader.loadTestsFromNames(sys.argv[1:])
except unittest.SkipTest as reason:  # a module that says so where it is imported
    print(f"SKIPPED: {', '.join(sys.argv[1:])}: {reason}")
    sys.exit(77)
if suite.countTestCases() == 0:
    sys.exit("There are no tests in " + ", ".join(sys.argv[1:]))
result = unittest.TextTestRunner(verbosity=2).run(suite)
if not result.wasSuccessful():
    sys.exit(1)
for test, reason in result.skipped:
    print(f"SKIPPED: {test}: {reason}")
sys.exit(77 if result.skipped else 0)
