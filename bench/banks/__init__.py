"""The banks that banks.py sets side by side: built, run, tabled."""
