"""Which library of HDF5 is asked for what h5py has no name for."""

import unittest

from underact import opening

PLACE = "7f0000000000-7f0000001000 r-xp 00000000 08:01 1234   "


class TheLibraryOfHdf5(unittest.TestCase):
    def test_is_the_one_that_is_loaded(self):
        lines = [PLACE + "/usr/lib/libhdf5_serial.so.103", PLACE + "/usr/lib/libhdf5_serial_hl.so"]
        self.assertEqual(opening._libraries_in(lines), ["/usr/lib/libhdf5_serial.so.103"])
        self.assertIsNotNone(opening._library())

    def test_is_never_one_in_the_folder_one_stands_in(self):
        lines = [PLACE + "/home/a person/lib/libhdf5.so", PLACE + "[anon: libhdf5]", PLACE]
        self.assertEqual(opening._libraries_in(lines), ["/home/a person/lib/libhdf5.so"])


if __name__ == "__main__":
    unittest.main()
