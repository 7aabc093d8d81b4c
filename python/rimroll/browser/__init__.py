"""The lab in a browser or a notebook.

`setup` writes what is computed in Python as the set-up of the page and checks it, `page` finds the
page, makes one file of it and serves it, and `view` shows it.
"""
