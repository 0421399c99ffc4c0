"""The figures of the thesis that hold data, remade: run, drawn, and checked against what they
should show.
"""
